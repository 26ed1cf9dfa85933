"""The report on a model: one self-contained HTML page for people."""

from quintrig.report.write import write_report as write_report
