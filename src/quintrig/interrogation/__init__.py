"""Lines that are read from surfaces, and umbilics: level sets, integral curves, geodesics."""
