"""Every relation of the hunt by its name, in the order in which statements are given to them."""
from relations_contacts import Bearings, Capstan, CordEnds, Feet, Rough
from relations_drives import Corner, EqualWheels, FarCenter, NeverReached, SlowShaking
from relations_gears import Teeth
from relations_matter import Doubled, Massless, Split
from relations_measure import Sizes, Units
from relations_mirror import Mirrored
from relations_motion import Growth, Halfway, MovingFrame, Shaken
from relations_plane import InSpace, OtherPlane
from relations_space import Shifted, Turned
from relations_unknowns import Hidden, Letters
from relations_writing import Names, Order

RELATIONS = {relation.name: relation for relation in (
    Units(), Sizes(), Order(), Names(), Split(), Massless(), Doubled(), Letters(), Hidden(), Halfway(), MovingFrame(),
    Growth(), Shaken(), Turned(), Shifted(), Mirrored(), Feet(), Rough(), Teeth(), Bearings(), Capstan(), CordEnds(), OtherPlane(), InSpace(),
    FarCenter(), EqualWheels(), NeverReached(), Corner(), SlowShaking())}
