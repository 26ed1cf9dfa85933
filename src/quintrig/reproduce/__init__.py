"""The thesis's numbered figures and tables, rebuilt from models into one page to browse."""

from quintrig.reproduce.inventory import chosen as chosen
from quintrig.reproduce.inventory import inventory as inventory
from quintrig.reproduce.inventory import inventory_text as inventory_text
from quintrig.reproduce.page import write_reproduction as write_reproduction
