"""What the program writes and prints, as types. Made by tools/python_types.py from docs/schema/commands.schema.json; do not edit."""

from __future__ import annotations

from typing import Literal, NotRequired, TypeAlias, TypedDict

Ability: TypeAlias = Literal['kneel', 'crouch', 'crawl', 'step_back', 'run']
"""
Something that a person does only where the cell file says so: each makes the search larger, and no standard counts on it.
"""


Action: TypeAlias = str
"""
A walk and a posture, for 200 ms, those of the second person behind them where there is one, and the controls that are worked meanwhile, by their numbers in the cell file.
"""


class AgreementExact(TypedDict):
    """
    Every bit of every output.
    """

    result: Literal['exact']


class AgreementFailed(TypedDict):
    """
    The FMU returned an error.
    """

    reason: str
    """
    What it said.
    """
    result: Literal['failed']


class AgreementNotOffered(TypedDict):
    """
    The FMU does not offer this.
    """

    result: Literal['not_offered']


class AnywhereSpent(TypedDict):
    """
    What it took.
    """

    arm_boxes: int
    """
    Boxes of joint angles that they looked at.
    """
    arm_checks: int
    """
    Arm searches.
    """
    boxes: int
    """
    Sets of poses that were looked at.
    """
    fmu_steps: int
    """
    Communication steps of the FMU.
    """
    run_again: int
    """
    Steps of the FMU that were run again from the start and compared.
    """


class Apart(TypedDict):
    """
    How far an output is apart in two runs.
    """

    output: str
    """
    Its name.
    """
    share: float
    """
    The largest difference as a share of what it ranges over; of one that counts or is true or false, the share of rows that
    differ. What comes up to half a communication step earlier or later (a whole one, of the latter) is no difference.
    """


class ApproachPath(TypedDict):
    """
    A way past a safeguard to the robots.
    """

    at_s: float
    """
    When it does, s after the beginning of the run.
    """
    clause: str | None
    """
    Clause of the standard.
    """
    edge_m: list[float]
    """
    The point of the safeguard's edge that is nearest, m.
    """
    formula: str | None
    """
    The formula with its numbers.
    """
    how: str
    """
    How somebody comes: through it, over it, into it and so on.
    """
    known: bool
    """
    Whether S is known, and not only the least that it can be.
    """
    link: str
    """
    The link that comes nearest.
    """
    margin_mm: int | None
    """
    That less S, mm.
    """
    s_mm: int | None
    """
    S, mm: rounded up; none for a sensor that does not stop the robots.
    """
    stands_mm: int
    """
    How far the safeguard is from the nearest point that a moving robot reaches, mm: rounded down.
    """


class Arm(TypedDict):
    """
    The touching arm.
    """

    elbow_m: list[float]
    """
    Elbow, m.
    """
    held_m: NotRequired[float | None]
    """
    Where what the hand holds is hit: how far beyond the finger tips, m.
    """
    shoulder_m: list[float]
    """
    Shoulder joint, m.
    """
    side: str
    """
    `left` or `right`.
    """
    wrist_m: list[float]
    """
    Wrist, m.
    """


BodyOrArm: TypeAlias = Literal['body', 'arm']
"""
What of the person is hit: an arm needs other guards than the rest.
"""


BodyRegion: TypeAlias = Literal['skull_forehead', 'face', 'neck', 'neck_front', 'back_shoulders', 'chest', 'abdomen', 'pelvis', 'upper_arm', 'lower_arm', 'hand', 'thigh', 'lower_leg']
"""
A body region of ISO/TS 15066, Table A.2. Its text form (`Display`, `FromStr`, serde) is [`BodyRegion::id`].
"""


Level: TypeAlias = int


class Change(TypedDict):
    """
    A change of the cell with which a cause was not met any more.
    """

    change: str
    """
    In words.
    """
    checked: str
    """
    What it was held against, in words.
    """
    complete: bool
    """
    Whether every sequence of the changed cell was looked at.
    """
    enough_until_s: NotRequired[float | None]
    """
    Nothing is hazardous with it: every sequence was looked at, and everybody who comes from anywhere until then, s after the start of
    the FMU. Without it that is not shown.
    """
    less: str
    """
    What the next smaller change leads to, in words.
    """
    removes_all: bool
    """
    Whether nothing in the cell is hazardous with it; else only this cause is gone.
    """


Change2: TypeAlias = Literal['new', 'worse', 'same', 'less', 'not_found_again', 'fixed']
"""
What became of a hazard.
"""


class Clamping(TypedDict):
    """
    What holds a part of the body.
    """

    against: str
    """
    What does not give way: the floor, an obstacle, a link.
    """
    at_m: list[float]
    """
    Point of the robot from which the gap is measured, m.
    """
    closing_m_s: float
    """
    How fast the gap closes, m/s.
    """
    force_n: float
    """
    Force on the part, N.
    """
    gap_m: float
    """
    Width of the gap, m.
    """
    limit_n: float
    """
    Quasi-static limit, N.
    """
    toward: list[float]
    """
    Unit vector from there towards what does not give way.
    """
    travel_m: float
    """
    How far the robot goes on after the contact, as far as that counts, m.
    """


class ClampingRecord(TypedDict):
    """
    How clamping counts.
    """

    contact_signal: NotRequired[str | None]
    """
    The FMU input that tells robots of a contact.
    """
    travel_after_contact_m: float
    """
    How far the link that goes on farthest after a contact does, m.
    """


Class: TypeAlias = Literal['force', 'head_contact', 'clamping', 'pressure', 'moving_contact', 'separation']
"""
Which criterion a hazard breaks.
"""


ContactKind: TypeAlias = Literal['transient', 'quasi_static', 'none']
"""
Whether the part of the body can give way.
"""


ControlKind: TypeAlias = Literal['momentary', 'held', 'toggled']
"""
How a control is worked.
"""


ControlledBy: TypeAlias = Literal['person', 'anyone', 'nobody']
"""
Who can work a control.
"""


Criterion: TypeAlias = Literal['absolute', 'approach']
"""
Which speed makes the force that decides whether a contact is unsafe, and how bad.
"""


class CycleShare(TypedDict):
    """
    The time in which people were followed, and what the robots repeat while somebody stands at the start and does nothing. Times count from
    the FMU's own start.
    """

    cycle_s: float | None
    """
    The robots repeat what they do every so many seconds; nothing if that was not seen.
    """
    from_s: float
    """
    People begin then, s.
    """
    moves: bool
    """
    Whether any robot went anywhere meanwhile.
    """
    repeats_from_s: float | None
    """
    From this time on, s; what they do before it comes once. At the earliest the time at which the person begins: what is before that
    was not watched.
    """
    until_s: float
    """
    Their sequences end then, s.
    """
    watched_s: float
    """
    So long the robots were watched, s. They are watched for 64 s or 3200 communication steps, whichever is less, not beyond the FMU's
    stopTime, and no longer than they need to show the cycle twice. 0: the FMU could not finish the first 8 s.
    """


Difference: TypeAlias = Literal['number', 'truth', 'sign_of_zero', 'not_finite', 'unreadable']
"""
In what two values differ that should be the same.
"""


Edition: TypeAlias = Literal['2010', '2024']
"""
Which edition of the standard.
"""


Effect: TypeAlias = Literal['stops', 'slows', 'starts', 'speeds_up', 'changes', 'nothing']
"""
What the robots do after an input has changed.
"""


class EventDoing(TypedDict):
    """
    What is being done, whenever that changes.
    """

    event: Literal['doing']
    text: str
    """
    In words.
    """


class EventProgress(TypedDict):
    """
    How far it is, at most ten times a second.
    """

    done: int
    """
    So many are done.
    """
    event: Literal['progress']
    text: str
    """
    What came of it so far, in words.
    """
    total: int
    """
    Of so many. A search of all sequences begins anew with each action.
    """
    unit: str
    """
    What is counted.
    """


class EventResults(TypedDict):
    """
    The results are written into this folder.
    """

    event: Literal['results']
    folder: str
    """
    From the folder in which the program was started.
    """


class EventNote(TypedDict):
    """
    Something to know.
    """

    event: Literal['note']
    text: str
    """
    In words.
    """


class EventWarning(TypedDict):
    """
    Something that may make a result mean something else.
    """

    event: Literal['warning']
    text: str
    """
    In words.
    """


class EventError(TypedDict):
    """
    Why the program ends, or why a part of its work was left out.
    """

    event: Literal['error']
    text: str
    """
    What it is, and what to do about it.
    """


class ExhaustiveCheck(TypedDict):
    """
    A complete search.
    """

    actions: int
    """
    How many actions they have.
    """
    beginning: int
    """
    From which of the cell's beginnings, from 1.
    """
    looked_at: int
    """
    All of so many actions were looked at.
    """
    reasons: list[str]
    """
    Why not all; nothing if it is complete.
    """
    sequences: str
    """
    How many sequences there are, in decimal.
    """


StartItem: TypeAlias = list[float]


class FaultRecord(TypedDict):
    """
    An action the FMU could not finish.
    """

    actions: list[Action]
    """
    The sequence.
    """
    message: str
    """
    What happened.
    """


class FileSubject(TypedDict):
    """
    A file that says part of what the cell is.
    """

    path: str
    """
    As the cell file names it; of a system of FMUs the file name.
    """
    sha256: str
    """
    SHA-256 of the file.
    """


FirstContact = TypedDict(
    'FirstContact',
    {
        'body_region': BodyRegion,
        'class': Class,
        'person': NotRequired[str | None],
        'ratio': float,
        'robot_link': str,
        'time_s': float,
    },
)


Span: TypeAlias = int


class FloorCell(TypedDict):
    """
    A cell of the floor.
    """

    earliest_s: float
    """
    When the earliest of those is hit, after the start of the FMU, s.
    """
    ratio: float
    """
    Force over limit of the worst that was tried.
    """
    spans: list[tuple[Span, float]]
    """
    Number of a span of time, and force over limit of the worst that was tried there and then. Of spans that are not listed
    nothing was found in the poses that were tried; others may be hit then.
    """
    unseen: bool
    """
    Whether somebody is hit there whom no sensor has seen; else only who was seen on the way, as soon as they may be there by
    bounds on their way.
    """
    xy_m: list[float]
    """
    Its middle, floor plan, m.
    """


class FmuSubject(TypedDict):
    """
    An FMU that was scanned.
    """

    fmi_version: str
    """
    FMI version.
    """
    generation_tool: str
    """
    Exporting tool.
    """
    model_name: str
    """
    Model name.
    """
    sha256: str
    """
    SHA-256 of the FMU file.
    """
    unit: str
    """
    Name of the unit; empty for the only one.
    """


class Ground(TypedDict):
    """
    The floor as rectangles, each by its low x and y and its high x and y, m.
    """

    swept_m: list[list[float]]
    """
    What the robots sweep, seen from above, while nobody is seen.
    """
    unseen_m: list[list[float]]
    """
    Where people can be who came there unseen, as far as sensors leave that open.
    """
    watched_m: list[list[float]]
    """
    Where else people can be: sensors see them there, or on the way there.
    """


class Headline(TypedDict):
    """
    The head of a result.
    """

    covers: str
    """
    What was asked, and what of it was looked at.
    """
    says: str
    """
    What was found, or why nothing is said.
    """


class InitialConditionRecord(TypedDict):
    """
    Where and when a person begins.
    """

    begins_s: float
    """
    Time from the FMU's own start, s.
    """
    heading_deg: float
    """
    Heading from +x towards +y, degrees.
    """
    xy_m: list[float]
    """
    Floor plan, m.
    """


LimitKind: TypeAlias = Literal['force', 'pressure', 'motion', 'distance']
"""
What the limit is one of.
"""


class Line(TypedDict):
    """
    The hazards of a cause in which one link hits one region.
    """

    body_region: BodyRegion
    """
    What is hit.
    """
    hazards: list[str]
    """
    Their ids, worst first.
    """
    held: NotRequired[bool]
    """
    Whether that is what the hand holds.
    """
    ratio: float
    """
    The highest force over its limit.
    """
    robot_link: str
    """
    By what.
    """


class Moment(TypedDict):
    """
    What an input does at another moment.
    """

    at_s: float
    """
    Time from the beginning of the run to the change of the input, s.
    """
    effect: Effect
    """
    What it does then.
    """
    still_after_s: float | None
    """
    Time from the change until the robots stand still, s.
    """


class MotionSame(TypedDict):
    """
    The same motion.
    """

    most: Apart
    """
    Of the outputs that are bound, the one that differs most.
    """
    result: Literal['same']
    unbound: NotRequired[Apart | None]
    """
    An output that the cell does not bind and that shows another motion.
    """


class MotionDiffers(TypedDict):
    """
    Another motion.
    """

    most: Apart
    """
    The bound output that differs most.
    """
    result: Literal['differs']


class MotionFailed(TypedDict):
    """
    The FMU failed in the other run.
    """

    reason: str
    """
    What it said.
    """
    result: Literal['failed']


class NarrowerNotRecorded(TypedDict):
    """
    A record does not say where its person begins, or which body they have: an older version wrote it.
    """

    what: Literal['not_recorded']


class NarrowerFromElsewhere(TypedDict):
    """
    One question is about people from anywhere, the other about one beginning.
    """

    what: Literal['from_elsewhere']


class NarrowerBeginning(TypedDict):
    """
    The person begins at another place or time.
    """

    what: Literal['beginning']


class NarrowerSeenAtStart(TypedDict):
    """
    This sensor reports somebody already where the person begins, which it did not.
    """

    sensor: str
    """
    The sensor.
    """
    what: Literal['seen_at_start']


class NarrowerFloor(TypedDict):
    """
    The floor that people may be on is another, or where they come from.
    """

    what: Literal['floor']


class NarrowerHorizon(TypedDict):
    """
    It ends earlier, or its sequences are shorter than the hazard's.
    """

    what: Literal['horizon']


class NarrowerInterval(TypedDict):
    """
    Contacts are looked for at longer intervals.
    """

    what: Literal['interval']


class NarrowerTolerance(TypedDict):
    """
    A deeper contact may be missed.
    """

    what: Literal['tolerance']


class NarrowerEdition(TypedDict):
    """
    The edition of the limits is another.
    """

    what: Literal['edition']


NarrowerCriterion = TypedDict(
    'NarrowerCriterion',
    {
        'class': Class,
        'what': Literal['criterion'],
    },
)


class NarrowerSpeed(TypedDict):
    """
    The force is made by another speed.
    """

    what: Literal['speed']


class NarrowerMovingContact(TypedDict):
    """
    Contacts count from a higher speed on.
    """

    what: Literal['moving_contact']


class NarrowerTravel(TypedDict):
    """
    Robots are stated to go on less far after a contact.
    """

    what: Literal['travel']


class NarrowerSurface(TypedDict):
    """
    How small the surface of this link is that touches is not told.
    """

    link: str
    """
    The link.
    """
    what: Literal['surface']


class NarrowerSeparation(TypedDict):
    """
    A term of the separation distance is smaller.
    """

    term: str
    """
    Its key in the cell file.
    """
    what: Literal['separation']


class NarrowerBody(TypedDict):
    """
    The person has another body.
    """

    what: Literal['body']


class NarrowerArms(TypedDict):
    """
    Arms are slower.
    """

    what: Literal['arms']


class NarrowerAbilities(TypedDict):
    """
    The person does other things, is slower, or holds something else.
    """

    what: Literal['abilities']


class NarrowerSecond(TypedDict):
    """
    The second person is another one, begins elsewhere, or is not there.
    """

    what: Literal['second']


class NarrowerControlMissing(TypedDict):
    """
    This control is worked on the way, and is missing.
    """

    control: str
    """
    The control.
    """
    what: Literal['control_missing']


class NarrowerControlOtherwise(TypedDict):
    """
    This control is worked on the way, and in another way, by fewer people, or for another time.
    """

    control: str
    """
    The control.
    """
    what: Literal['control_otherwise']


class NarrowerPresses(TypedDict):
    """
    Controls are worked less often.
    """

    what: Literal['presses']


class NarrowerHidden(TypedDict):
    """
    It found others that may hide it: of those with which sequences do not end, each action tells the worst only.
    """

    what: Literal['hidden']


Narrower: TypeAlias = NarrowerNotRecorded | NarrowerFromElsewhere | NarrowerBeginning | NarrowerSeenAtStart | NarrowerFloor | NarrowerHorizon | NarrowerInterval | NarrowerTolerance | NarrowerEdition | NarrowerCriterion | NarrowerSpeed | NarrowerMovingContact | NarrowerTravel | NarrowerSurface | NarrowerSeparation | NarrowerBody | NarrowerArms | NarrowerAbilities | NarrowerSecond | NarrowerControlMissing | NarrowerControlOtherwise | NarrowerPresses | NarrowerHidden
"""
What of a later question is narrower than in an earlier one.
"""


Need: TypeAlias = Literal['searched', 'finished', 'arm_searches', 'between_steps', 'confirmed', 'repeatable', 'steps', 'speeds', 'moves', 'near', 'reported', 'changes', 'presses', 'hands_of_controls', 'doors', 'abilities', 'hands_through_planes', 'following', 'approach', 'criteria', 'pressure', 'travel', 'people_alike', 'heeds', 'reports_later', 'reports_while_worked']
"""
Something that "nobody is hit" needs.
"""


class NotTried(TypedDict):
    cause: str
    """
    Why.
    """


class NextSmallerNotTried(TypedDict):
    """
    It cannot be tried.
    """

    not_tried: NotTried


class NumberedInitialCondition(TypedDict):
    """
    Where and when the person begins; times of hazards count from then.
    """

    begins_s: float
    """
    Time from the FMU's own start, s.
    """
    heading_deg: float
    """
    Where the person looks, degrees from +x towards +y.
    """
    number: int
    """
    Its number, from 1.
    """
    of: int
    """
    How many the cell has.
    """
    xy_m: list[float]
    """
    Where the person stands, m.
    """


class ObligationShown(TypedDict):
    """
    It is so.
    """

    about: NotRequired[str | None]
    """
    Of which robot, sensor or control, where there are several.
    """
    need: Need
    """
    What is needed.
    """
    says: str
    """
    The same in words.
    """
    figure: str
    """
    How far that was looked at, in words with a figure.
    """
    standing: Literal['shown']


class ObligationAssumed(TypedDict):
    """
    It was only tried out, and the cell file accepts it.
    """

    about: NotRequired[str | None]
    """
    Of which robot, sensor or control, where there are several.
    """
    need: Need
    """
    What is needed.
    """
    says: str
    """
    The same in words.
    """
    because: str
    """
    Why.
    """
    by: str
    """
    Who does.
    """
    standing: Literal['assumed']
    tried: str
    """
    How far it was tried out.
    """


class ObligationOpen(TypedDict):
    """
    It is not known.
    """

    about: NotRequired[str | None]
    """
    Of which robot, sensor or control, where there are several.
    """
    need: Need
    """
    What is needed.
    """
    says: str
    """
    The same in words.
    """
    accept: NotRequired[str | None]
    """
    Lines for the cell file that accept it, where that can be accepted.
    """
    standing: Literal['open']
    what_to_do: NotRequired[str | None]
    """
    What to do about it, as a sentence.
    """
    why: str
    """
    Why, and where.
    """


Obligation: TypeAlias = ObligationShown | ObligationAssumed | ObligationOpen
"""
Something that an answer needs, and what is known of it.
"""


Obligations: TypeAlias = list[Obligation]
"""
All that an answer needs.
"""


class OperatedControl(TypedDict):
    """
    A control that is worked in an action.
    """

    at_s: float
    """
    When the action begins, s.
    """
    by: ControlledBy
    """
    Who works it.
    """
    by_either: NotRequired[bool]
    """
    Whether either of two people may be the one who works it.
    """
    door: NotRequired[bool]
    """
    Whether it opens a door and closes it again.
    """
    kind: ControlKind
    """
    How it is worked.
    """
    name: str
    """
    Its name.
    """
    opens: NotRequired[bool | None]
    """
    Of a door: whether it is opened, or closed.
    """
    pressed_steps: NotRequired[int | None]
    """
    Of a momentary one: for how many communication steps it is pressed.
    """


class Outside(TypedDict):
    """
    A person outside a zone.
    """

    distance_m: float
    """
    From the middle between the feet to the zone's edge, m.
    """
    name: str
    """
    The sensor.
    """


Placed: TypeAlias = Literal['far_enough', 'not_known', 'too_near']
"""
Whether a safeguard stands far enough away.
"""


class Pressure(TypedDict):
    """
    A pressure and its limit.
    """

    clamped: bool
    """
    Whether it is that of a part that cannot give way.
    """
    limit_n_cm2: float
    """
    The limit, N/cm2.
    """
    n_cm2: float
    """
    The pressure, N/cm2.
    """


class Problem(TypedDict):
    """
    Something wrong with a cell.
    """

    file: str
    """
    The cell file, or one that it extends.
    """
    help: str | None
    """
    What to do about it.
    """
    line: int | None
    """
    Its line.
    """
    message: str
    """
    What is wrong.
    """


class Radii(TypedDict):
    """
    Radii of body parts, m, instead of those of the median man scaled by stature: of the person who will work there, or with
    thick clothes. What stops a walk, and where joints are, stays as it is.
    """

    abdomen: float | None
    """
    Abdomen.
    """
    head: float | None
    """
    Head, a sphere.
    """
    lower_chest: float | None
    """
    Chest at the height of the lower ribs.
    """
    neck: float | None
    """
    Neck.
    """
    pelvis: float | None
    """
    Pelvis.
    """
    shank: float | None
    """
    Both lower legs.
    """
    thigh: float | None
    """
    Both thighs.
    """
    upper_chest: float | None
    """
    Chest at the height of the armpits, and shoulders.
    """


class RandomSearch(TypedDict):
    """
    Exact figures of uniform random search, from the share of hazardous sequences.
    """

    iterations: int
    """
    Budget, iterations.
    """
    iterations_to_hazard: float | None
    """
    Mean iterations to the first hazard, however many it takes: one over the share of hazardous sequences.
    """
    mean_iterations: float
    """
    The same cut at the budget, a miss counting as the budget: what the paper's tables call T.
    """
    miss_probability: float
    """
    Probability to find nothing.
    """
    sigma: float
    """
    Standard deviation of that.
    """


class Reaction(TypedDict):
    """
    What an input does.
    """

    at_other_moments: list[Moment]
    """
    What the same change does at other moments, where that was tried.
    """
    at_s: float
    """
    Time from the beginning of the run to the change of the input, s.
    """
    effect: Effect
    """
    What the other value does.
    """
    first_change_s: float | None
    """
    Time from the change of the input to the first change of any output, s.
    """
    idle: bool
    """
    Its value in the run to compare with.
    """
    input: str
    """
    The input, or the sensor that drives it.
    """
    mean_speed: list[float]
    """
    Mean speed in the second half of the time after the change: idle, then changed.
    """
    still_after_s: float | None
    """
    Time from the change of the input until the robots stand still, s.
    """


class RemedyFromAnywhere(TypedDict):
    """
    A search from anywhere in which nobody was shown to be hit.
    """

    reasons: list[str]
    """
    Why it does not show that nobody is hit; nothing if it does.
    """
    until_s: float
    """
    How long after the start of the FMU, s.
    """


class NoAdvice(TypedDict):
    cause: str
    """
    The reason.
    """


class RemedyOutcomeNoAdvice(TypedDict):
    """
    It is met no more, for a reason that does not count.
    """

    no_advice: NoAdvice


class NoHelp(TypedDict):
    limit: str | None
    """
    Why no more of the change was tried.
    """


class RemedyOutcomeNoHelp(TypedDict):
    """
    The hazard is still met.
    """

    no_help: NoHelp


class RemedyOutcomeNotTried(TypedDict):
    """
    The cell or the FMU does not take the change.
    """

    not_tried: NotTried


class ReplayedContact(TypedDict):
    """
    A contact.
    """

    body_region: BodyRegion
    """
    What is hit.
    """
    force_n: float
    """
    Force by the speed that decides, N.
    """
    robot_link: str
    """
    By what.
    """
    time_s: float
    """
    When, s.
    """


class Reported(TypedDict):
    """
    What a sensor inside the FMU did while the person stood at many places, one after the other.
    """

    at: int
    """
    Places in and around the cell at which it reported the person.
    """
    far_away: bool
    """
    Whether it reported a person far away from the cell.
    """
    of: int
    """
    Such places that were tried.
    """
    sensor: str
    """
    The sensor.
    """


class Reports(TypedDict):
    """
    What a sensor reports on the way.
    """

    changes_s: list[float]
    """
    Times at which it begins and ends to report the person, s; it begins with "clear".
    """
    name: str
    """
    Its name.
    """


Reproduction: TypeAlias = Literal['reproduced', 'differs', 'not_reproduced']
"""
What came of a hazard that was simulated again.
"""


class Robot(TypedDict):
    """
    The robot that hits.
    """

    mass_from: str
    """
    Where that is said.
    """
    moving_mass_kg: float
    """
    Mass of its moving parts, kg.
    """
    name: str
    """
    Its name.
    """


class RobotCoverage(TypedDict):
    """
    Figures of one robot.
    """

    closest_approach_m: float
    """
    Smallest distance between trunk, head or legs and this robot, m; negative when they met. `f64::MAX`: never measured, because
    nobody was within 1 m of its reach while any robot was fast enough to harm. An exhaustive search takes no notice of robots too slow
    to harm anyone, so ask `instants_in_reach` whether anybody was near.
    """
    instants_in_reach: int
    """
    Instants at which it was near enough to be touched in some posture: a link no farther from the point 1 m above somebody's feet
    than any part of them gets from there. What is in between is not looked at, nor whether the robot moved. Each instant of an action
    counts once, whatever follows from it, also those after a hazard.
    """
    instants_to_walk_to: int
    """
    Instants at which it was where somebody who walks, or runs, straight from the start with nothing in between could touch it by
    then. None of them: the time was too short, or the robot is elsewhere than in the real cell.
    """
    moved: bool
    """
    Whether anything of it changed its place, whatever speeds the FMU told.
    """
    name: str
    """
    Its name in the cell.
    """
    reachable: bool
    """
    Whether somebody can be near it at all by the end of the sequences: by the lengths of the robot and the person's speed alone. True
    where nothing bounds the robot (parts that slide, poses that the FMU gives, separation).
    """
    top_speed_m_s: float
    """
    Highest speed bound of any of its links, m/s, by the speeds that the FMU tells.
    """


class RunAgain(TypedDict):
    """
    How much of what an FMU did in a search was run again from the start, by a fresh instance with all inputs and without
    any restore, and gave the same in all bound outputs, bit for bit. Where it is not all, it is a sample, chosen by a key
    made from the inputs.
    """

    compared: int
    """
    Of these, run again.
    """
    merges: int
    """
    Histories that were merged with another one, which went on.
    """
    merges_compared: int
    """
    Of these, run on from the start with the other one's inputs.
    """
    transitions: int
    """
    Actions of the FMU that were stepped.
    """


class SensorState(TypedDict):
    """
    A sensor's output.
    """

    name: str
    """
    Sensor name.
    """
    person_detected: bool
    """
    Whether it reports the person.
    """
    since_s: float | None
    """
    For how long before the contact it had reported the person without a break, s; none if it does not report them, or
    the hazard was not confirmed.
    """


class Separation(TypedDict):
    """
    How near a robot is.
    """

    distance_m: float
    """
    Distance from the person, arms left out, m.
    """
    required_m: float | None
    """
    Protective separation distance, m; none if the robot does not stop at all.
    """
    stops_after_s: float | None
    """
    How long the robot goes on if it is stopped at that instant, s; none if it does not stand within the time that is waited.
    """
    travel_m: float
    """
    How far the link gets in that time at most, m.
    """


Sex: TypeAlias = Literal['woman', 'man']
"""
Sex of the ANSUR II figures.
"""


class Shortest(TypedDict):
    """
    The shortest sequence found that ends in a hazard; of these the calmest. The very shortest there is when the search
    was exhaustive.
    """

    actions: list[Action]
    """
    The actions.
    """
    confirmed: bool | None
    """
    Whether a fresh instance without any restore gave the same contact; `None` before that was tried.
    """
    force_n: float
    """
    Force, N.
    """
    ratio: float
    """
    `force / limit`.
    """
    time_s: float
    """
    Time of the contact, s.
    """


class SpeedRecord(TypedDict):
    """
    A speed that the FMU tells and that is not the speed of the motion.
    """

    cause: str | None
    """
    The likely cause, where it can be recognised.
    """
    motion: float
    """
    Speed of the motion then: the way of the step before by its time.
    """
    of_steps: int
    """
    Steps of a run.
    """
    part: str
    """
    The joint or frame.
    """
    robot: str
    """
    The robot.
    """
    slower_than_it_is: bool
    """
    Whether it is anywhere told slower than it is: forces then come out too low.
    """
    steps: int
    """
    Steps of a run at which the two differ in some run.
    """
    time_s: float
    """
    When the two differ most, from the person's beginning, s.
    """
    told: float
    """
    Speed that is told then.
    """
    unit: str
    """
    Unit of the speeds here: m/s or rad/s.
    """
    variables: list[str]
    """
    The outputs that are named as its speed.
    """


class Spent(TypedDict):
    """
    What the search cost.
    """

    actions: int
    """
    200 ms actions simulated.
    """
    arm_checks: int
    """
    Arm searches.
    """
    contact_checks: int
    """
    Person-robot comparisons.
    """
    fmu_states: int
    """
    Different FMU states met.
    """
    fmu_steps: int
    """
    FMI communication steps of all different transitions; what was repeated to come back to a state is in run.json.
    """
    iterations: int
    """
    Iterations run.
    """


class StatedStop(TypedDict):
    """
    A stop of the robots, as the cell file states it.
    """

    reaction_s: float
    """
    From the command until they begin to brake, s.
    """
    stop_distance_m: float
    """
    How far a point of them gets while they brake, m.
    """
    stop_time_s: float
    """
    From then until they stand, s.
    """


class Stopped(TypedDict):
    """
    What a sensor does that begins to report at some moment.
    """

    at_s: float
    """
    When it begins to report, s after the beginning of the run.
    """
    still_after_s: float | None
    """
    Time until the robots stand still, s, if it stops them.
    """


class Subject(TypedDict):
    """
    What was scanned.
    """

    beginning: NotRequired[NumberedInitialCondition | None]
    """
    Which of the cell's beginnings it is, if there are several or it is not at once.
    """
    cell: str
    """
    Name of the cell.
    """
    cell_file: str | None
    """
    The cell file, if one was named beside the path; as `path`.
    """
    cell_found: str
    """
    Where the cell was found, as `path`; inside an archive behind a `!`.
    """
    cell_sha256: str
    """
    SHA-256 of the cell file.
    """
    couplings: list[str]
    """
    What the connections between them do.
    """
    files: NotRequired[list[FileSubject]]
    """
    Other files that say what was scanned: the system of FMUs, robot descriptions, meshes.
    """
    fmus: list[FmuSubject]
    """
    The FMUs, in the order in which they are stepped.
    """
    path: str
    """
    Path that was scanned: in a file, relative to its folder where that is possible.
    """


class Table(TypedDict):
    """
    Origin of one table of numbers.
    """

    confidence: str
    """
    How sure they are, in words.
    """
    id: str
    """
    Stable id in snake case.
    """
    source: str
    """
    What the numbers were taken from.
    """
    title: str
    """
    Standard or survey, edition, clause, and what the table holds.
    """
    verified: bool
    """
    Whether somebody compared the numbers with the purchased text.
    """


class Through(TypedDict):
    """
    A plane that told of an arm: a light curtain, a door, a two-hand control that it let go.
    """

    sensor: str
    """
    Its sensor.
    """
    since_s: float
    """
    How long before the contact the arm broke the plane or let go, s.
    """
    until_s: float
    """
    How long before the contact the sensor began to tell of the body itself, s: the robot then is as if the plane had told
    of the arm until that only. 0 if the plane tells of the arm until the contact.
    """


class Unlisted(TypedDict):
    """
    How often a random sequence ends in a hazard that is not listed.
    """

    checked: int
    """
    Random sequences after the first quarter of the search, each checked against the hazards known by then.
    """
    good_turing_estimate: float
    """
    Good-Turing estimate, no bound, from the random sequences alone: the probability that one more ends in a hazard
    that none of them ended in.
    """
    met_others: int
    """
    Of these, ended in a hazard not known then, or not evaluated.
    """
    probability_below: float
    """
    Upper bound, one-sided, of the probability that one more random sequence ends in a hazard that is not listed.
    """


class UntriedNotAsked(TypedDict):
    """
    It was not asked for, or by a version that did not have it.
    """

    kind: Literal['not_asked']


class UntriedCoupled(TypedDict):
    """
    Several FMUs, or one connected with itself: they exchange values once in a communication step.
    """

    kind: Literal['coupled']


class UntriedOwnSteps(TypedDict):
    """
    The FMU makes steps of its own length only.
    """

    kind: Literal['own_steps']
    step_s: float
    """
    This one, s.
    """


class UntriedClocks(TypedDict):
    """
    The FMU has clocks that are driven once in a communication step, or in Event Mode only.
    """

    kind: Literal['clocks']


class UntriedNotRepeated(TypedDict):
    """
    The FMU does not repeat its runs.
    """

    kind: Literal['not_repeated']


class UntriedNothingMoved(TypedDict):
    """
    No output moved.
    """

    kind: Literal['nothing_moved']


class UntriedNoEventMode(TypedDict):
    """
    The FMU has no Event Mode.
    """

    kind: Literal['no_event_mode']


class UntriedRefused(TypedDict):
    """
    The FMU refuses the step.
    """

    kind: Literal['refused']
    reason: str
    """
    What it said.
    """


Untried: TypeAlias = UntriedNotAsked | UntriedCoupled | UntriedOwnSteps | UntriedClocks | UntriedNotRepeated | UntriedNothingMoved | UntriedNoEventMode | UntriedRefused
"""
Why motions were not compared.
"""


Verdict: TypeAlias = Literal['hazards_found', 'none_found', 'inconclusive', 'fmu_failed', 'interrupted']
"""
Overall outcome; never a statement of safety.
"""


class VerifiedOutcomeFixed(TypedDict):
    """
    Its sequences, from where and when they began, end without an unsafe contact. Others may lead to the same hazard.
    """

    result: Literal['fixed']


class VerifiedOutcomeNoRoom(TypedDict):
    """
    Somebody has no room any more where it begins: nothing is known of who begins elsewhere.
    """

    result: Literal['no_room']


class VerifiedOutcomeSeen(TypedDict):
    """
    A sensor reports somebody already where it begins, which it did not: whoever gets there does so past that sensor.
    """

    result: Literal['seen']
    sensor: str
    """
    The sensor.
    """


class VerifiedOutcomeStill(TypedDict):
    """
    The robot does not move while the person stands where it begins: a robot that stands shows nothing.
    """

    result: Literal['still']
    robot: str
    """
    The robot.
    """


class VerifiedOutcomeStillThere(TypedDict):
    """
    One of them ends in an unsafe contact, the hardest of which is this.
    """

    body_region: str
    """
    Body region.
    """
    force_n: float
    """
    Force, N.
    """
    ratio: float
    """
    Force relative to the limit.
    """
    result: Literal['still_there']
    robot_link: str
    """
    Robot link.
    """
    time_s: float
    """
    Time of the contact, s.
    """


class VerifiedOutcomeNotJudged(TypedDict):
    """
    The changed cell asks less than the scan did, so what is not met is not fixed.
    """

    cause: Narrower
    """
    What of it is narrower.
    """
    result: Literal['not_judged']


class VerifiedOutcomeNotRun(TypedDict):
    """
    The FMU failed.
    """

    cause: str
    """
    Why.
    """
    result: Literal['not_run']


VerifiedOutcome: TypeAlias = VerifiedOutcomeFixed | VerifiedOutcomeNoRoom | VerifiedOutcomeSeen | VerifiedOutcomeStill | VerifiedOutcomeStillThere | VerifiedOutcomeNotJudged | VerifiedOutcomeNotRun
"""
What became of a hazard.
"""


class WatchedHistory(TypedDict):
    """
    One history of the FMU.
    """

    instants: int
    """
    Different instants at which a robot could harm somebody.
    """
    sensors: list[SensorState]
    """
    What the sensors report since somebody came to where they do.
    """
    unseen: bool
    """
    Whether that is from the start on: nobody was seen before.
    """


class AgreementDiffers(TypedDict):
    """
    Different; the largest relative difference `|a - b| / max(1, |a|)`.
    """

    first: Difference
    """
    In what the first one differs.
    """
    largest: float
    """
    Largest relative difference of numbers; 0 where all numbers are the same.
    """
    output: NotRequired[str | None]
    """
    The first output that differs.
    """
    result: Literal['differs']


Agreement: TypeAlias = AgreementExact | AgreementDiffers | AgreementFailed | AgreementNotOffered
"""
How two runs that should agree compare.
"""


class BodyRecord(TypedDict):
    """
    Whose body it is and how far it bends.
    """

    bend_forward_deg: float
    """
    How far they bend forward, degrees.
    """
    bend_lateral_deg: float
    """
    How far they bend to the side, degrees.
    """
    percentile: int
    """
    Percentile of the body measures: 5, 50 or 95.
    """
    radii_m: NotRequired[Radii]
    """
    Radii of body parts that the cell file says, m.
    """
    sex: Sex
    """
    Sex of the body measures.
    """


class CauseAdvice(TypedDict):
    """
    What was found against a cause.
    """

    changes: list[Change]
    """
    The smallest changes that were not found wanting, the surest first: only what is `enough` helps for sure.
    """
    note: str
    """
    What was tried, and what that is worth.
    """


class CauseChange(TypedDict):
    """
    A cause in both scans or in one of them.
    """

    after: int
    """
    Its hazards after.
    """
    before: int
    """
    Its hazards before.
    """
    change: Change2
    """
    What became of it: it is fixed when all its hazards are.
    """
    id: str
    """
    Its id.
    """
    sentence: str
    """
    What is wrong.
    """


class Certificate(TypedDict):
    """
    What an exhaustive search covered, and what random search can expect from that. Numbers of sequences are decimal
    strings: they do not fit into JSON's numbers.
    """

    actions: int
    """
    Actions to choose from.
    """
    complete: bool
    """
    Whether every sequence is accounted for, and nothing is open that this needs.
    """
    complete_for_actions: int
    """
    All sequences of so many actions were looked at.
    """
    covered: str
    """
    Those whose fate is known: hazardous, harmless or excluded.
    """
    excluded: str
    """
    Cannot meet one: too far away for the time that is left, by lengths and speeds.
    """
    fmu_transitions: int
    """
    Actions of the FMU that differ in its state or inputs.
    """
    harmless: str
    """
    Reached the horizon without.
    """
    hazardous: str
    """
    Met an unsafe state.
    """
    hazardous_share: float
    """
    Part of all sequences that is known to be hazardous.
    """
    horizon: int
    """
    Actions in a sequence.
    """
    levels: list[list[Level]]
    """
    Distinct states by number of actions before them, and how many of these were dropped as excluded.
    """
    merged: int
    """
    Histories that led to a state of the FMU known already, by its bytes.
    """
    merged_by: str
    """
    How equal states of the FMU were told.
    """
    merges_tried_out: int
    """
    Of these, tried out by stepping both states on.
    """
    not_evaluated: str
    """
    The FMU could not finish them.
    """
    questions: int
    """
    Different questions whether a person can be touched.
    """
    random_search: RandomSearch | None
    """
    What random search can expect, if the search was complete.
    """
    reasons: list[str]
    """
    Why that is not so: the obligations that are open, in words.
    """
    run_again: RunAgain
    """
    What of the FMU was run again plainly, to show that nothing rests on a state that was brought back wrongly.
    """
    sequences: str
    """
    All sequences: actions to the power of the horizon.
    """
    states: int
    """
    Distinct states.
    """


class ControlRecord(TypedDict):
    """
    A control of a cell.
    """

    by: ControlledBy
    """
    Who works it.
    """
    door: NotRequired[bool]
    """
    Whether it opens a door and closes it again.
    """
    kind: ControlKind
    """
    How it is worked.
    """
    name: str
    """
    Its name.
    """
    pressed_steps: NotRequired[int | None]
    """
    Of a momentary one: for how many communication steps it is pressed.
    """


class Coverage(TypedDict):
    """
    Figures beside a verdict.
    """

    actions: int
    """
    Actions simulated.
    """
    arm_boxes: int
    """
    Boxes of joint angles that all arm searches together looked at: what their work is measured in.
    """
    arm_checks: int
    """
    Arm searches run (an arm is searched only when the robot is in reach and fast enough to matter).
    """
    arm_checks_incomplete: int
    """
    Arm searches that stopped at their work limit before they could exclude a contact; zero unless a cell is extreme.
    """
    arm_runs_not_evaluated: int
    """
    Runs in which a plane tells of an arm that the FMU could not finish: what the arm meets there is not evaluated, never
    counted as safe.
    """
    checks_with_robot_in_arm_reach: int
    """
    Instants at which an arm could have bridged the distance to the robot, were nothing in between.
    """
    closest_approach_m: float
    """
    Smallest distance between trunk, head or legs and the robot, m; negative when they met. An exhaustive search takes
    no notice of robots too slow to harm anyone.
    """
    contact_checks: int
    """
    Instants at which person and robot were compared.
    """
    contacts_within_limits: int
    """
    Contacts met that stay within the limits, at the ends of episodes or with the trunk.
    """
    control_actions: list[int]
    """
    For each control, the number of actions in which it was worked. Empty as `robots` is.
    """
    episodes: int
    """
    Episodes begun.
    """
    episodes_not_evaluated: int
    """
    Episodes the FMU could not finish: not evaluated, never counted as safe.
    """
    highest_ratio_within_limits: float
    """
    Highest force ratio of those.
    """
    robot_top_speed_m_s: float
    """
    Highest speed bound of any robot link, m/s, by the speeds that the FMU tells.
    """
    robots: list[RobotCoverage]
    """
    Each robot, in the order of the cell. Empty where that was not looked at, as from anywhere.
    """
    sensor_actions: list[int]
    """
    For each sensor, the number of actions in which it reported the person.
    """
    walks_blocked: int
    """
    Actions in which an obstacle stopped the person's walk.
    """


HarmfulPose = TypedDict(
    'HarmfulPose',
    {
        'actions': list[Action],
        'begins_s': float,
        'body_region': BodyRegion,
        'cells': int,
        'class': Class | None,
        'confirmed': bool,
        'force_n': float,
        'heading_deg': float,
        'histories': int,
        'id': str,
        'limit_n': float,
        'posture': str,
        'ratio': float,
        'robot_link': str,
        'sensors': list[SensorState],
        'speed_m_s': float,
        'start_heading_deg': float,
        'start_m': list[float],
        'time_s': float | None,
        'walks_in': bool,
        'xy_m': list[float],
    },
)


HazardAfterChange = TypedDict(
    'HazardAfterChange',
    {
        'actions': list[Action],
        'body_region': BodyRegion,
        'class': Class,
        'from': InitialConditionRecord | None,
        'ratio': float,
        'robot_link': str,
        'time_s': float,
    },
)


class HazardChange(TypedDict):
    """
    A hazard in both scans or in one of them.
    """

    after: float | None
    """
    Force ratio after.
    """
    before: float | None
    """
    Force ratio before.
    """
    body_region: str
    """
    Body region.
    """
    change: Change2
    """
    What became of it.
    """
    id: str
    """
    Its id.
    """
    narrower: NotRequired[Narrower | None]
    """
    Why the later scan may not have told it though it is still there, if it was not found again and what the later scan asks
    is narrower.
    """
    robot_link: str
    """
    Robot link.
    """


class Judged(TypedDict):
    """
    How a hazard was judged.
    """

    breaks: list[Class]
    """
    All criteria that it breaks, the worst first.
    """
    clamping: NotRequired[Clamping | None]
    """
    What holds the part of the body.
    """
    contact: ContactKind
    """
    Whether the part of the body can give way, in what it breaks worst.
    """
    limit: LimitKind
    """
    What the limit is one of that it breaks worst.
    """
    pressure: NotRequired[Pressure | None]
    """
    The pressure.
    """
    separation: NotRequired[Separation | None]
    """
    How near the robot is, and should not be.
    """


class MotionNotTried(TypedDict):
    """
    Nothing was compared.
    """

    result: Literal['not_tried']
    why: Untried
    """
    Why.
    """


Motion: TypeAlias = MotionSame | MotionDiffers | MotionFailed | MotionNotTried
"""
How two runs compare that should show the same motion.
"""


class NextSmallerMet(TypedDict):
    """
    A hazard.
    """

    met: HazardAfterChange


class Close(TypedDict):
    change: str
    """
    The least of the change with which nothing was met, in words.
    """
    met: HazardAfterChange | None
    """
    What one step less than that leads to, if it is a hazard.
    """


class NextSmallerClose(TypedDict):
    """
    Nothing is met with a little less, and it is too close to be shown for everybody from anywhere.
    """

    close: Close


NextSmaller: TypeAlias = Literal['as_it_is'] | NextSmallerMet | NextSmallerNotTried | NextSmallerClose
"""
What the next smaller change leads to.
"""


class Probe(TypedDict):
    """
    What was found out about a cell.
    """

    fastest_m_s: float
    """
    Fastest point of any robot while nobody is detected, m/s.
    """
    idle_sensors: list[str]
    """
    Sensors that change nothing.
    """
    not_tried: NotRequired[list[str]]
    """
    Inputs that were not tried, because they are neither true nor false.
    """
    others: NotRequired[list[Reaction]]
    """
    What each other input does that is true or false, and that no sensor drives; where it was asked for.
    """
    reactions: list[Reaction]
    """
    What each sensor does that the cell drives.
    """
    reported: list[Reported]
    """
    What sensors inside the FMU report.
    """
    run_s: float
    """
    How long each run was, s.
    """
    together: Reaction | None
    """
    What all of them together do, if there are several.
    """
    warnings: list[str]
    """
    What seems to be wrong.
    """


class ReachabilityResult(TypedDict):
    """
    What came out.
    """

    any_time: NotRequired[bool]
    """
    Whether what is said to be clean is so for all time, as behaviours stand for all that the FMU ever does.
    """
    arm_tolerance_m: float
    """
    The same of contacts of arms, and those with less room for the arm, m.
    """
    between: int
    """
    Cells of the floor and postures in which nobody is hit at any communication step, and somebody may be between two: robots are
    taken to be as much nearer then as they may move in half a step.
    """
    between_m: list[list[float]]
    """
    Where those are: the middles, each once, floor plan, m.
    """
    body_tolerance_m: float
    """
    Contacts of trunk, head and legs that are harmless when the person stands no more than this elsewhere may be missed, m.
    """
    cell_m: float
    """
    Edge of the cells of the floor, m.
    """
    changes: int | None
    """
    How often what sensors report changed at most, if that was limited: coming in is one change, going out another.
    """
    cycle_s: float | None
    """
    How often the robots repeat what they do while nobody comes, s, if they did so twice until then.
    """
    floor: list[FloorCell]
    """
    Cells of the floor in which somebody who stands there is hit, row by row.
    """
    followed: bool
    """
    Whether poses that are hit at some moment were looked at in each span of time.
    """
    ground: Ground
    """
    The floor, and what the robots sweep.
    """
    hazards: list[HarmfulPose]
    """
    Of each body region and robot link the worst that was tried, the worst first.
    """
    histories: list[WatchedHistory]
    """
    What the robots did while sensors reported what they report of somebody unseen.
    """
    not_looked_at: int
    """
    Cells of the floor that were not looked at to the end, where the search ended early: nobody was found to be hit there, and not
    everything that sensors may report was followed.
    """
    not_looked_at_m: list[list[float]]
    """
    Where those are, and what is farther out, as rectangles by low x and y and high x and y, floor plan, m.
    """
    obligations: Obligations
    """
    What the result rests on: everything that "nobody is hit" needs, shown, assumed or open.
    """
    open: int
    """
    Cells of the floor and postures of which it is not known whether anybody is hit in them.
    """
    open_m: list[list[float]]
    """
    Where something is open: the middles of those cells, each once, floor plan, m.
    """
    presses: NotRequired[int | None]
    """
    How often controls were worked at most, all together, if the cell has any that are.
    """
    reasons: list[str]
    """
    Why the absence of further hazards is not shown: the obligations that are open, in words.
    """
    schema_version: int
    """
    Version of this form, that of scan results.
    """
    span_s: float
    """
    Length of the spans of time of `floor`, s: the first begins with the FMU.
    """
    speed_criterion: Criterion
    """
    Which speed decides. With that of approach, this is about people who stand: who walks comes to the robot faster.
    """
    spent: AnywhereSpent
    """
    What it took.
    """
    step_tolerance_m: float
    """
    Contacts between two communication steps that are harmless with links that are smaller by this may be missed, m.
    """
    subject: Subject
    """
    What was looked at.
    """
    tool: str
    """
    Program and version.
    """
    until_s: float
    """
    How long after the start of the FMU, s.
    """
    verdict: Verdict
    """
    Result in one word. `none_found` is said only where no obligation is open.
    """
    warnings: list[str]
    """
    What the user should know.
    """


class RemedyOutcomeOnlyLater(TypedDict):
    """
    No hazard is met within the time that the cell file looks at, but later.
    """

    only_later: HazardAfterChange


class ReplayedHazard(TypedDict):
    """
    A recorded hazard, simulated again.
    """

    because: str | None
    """
    Why there is none.
    """
    begins: InitialConditionRecord | None
    """
    Where it begins, if that is not where the cell file says.
    """
    id: str
    """
    Its id.
    """
    now: ReplayedContact | None
    """
    The contact now, if there is an unsafe one.
    """
    recorded: ReplayedContact
    """
    The contact as it was recorded.
    """
    result: Reproduction
    """
    What came of it.
    """


class Residual(TypedDict):
    """
    What the uniformly random sequences of a search say about what is left, each figure with 95 % confidence. Sequences
    that a strategy chose are never counted.
    """

    hazardous: int
    """
    Of these, hazardous by their own end; findings in other postures of their walks do not count.
    """
    hazardous_share_below: float
    """
    Upper bound, one-sided, of the same share.
    """
    hazardous_share_interval: list[float]
    """
    Clopper-Pearson interval, two-sided, of the share of all sequences that is hazardous: what an exhaustive search
    gives as `hazardous / sequences`.
    """
    holds_for: str
    """
    What the figures hold for.
    """
    not_evaluated: int
    """
    Of these, not evaluated, because the FMU could not finish them; upper bounds count them as the worse.
    """
    random_sequences: int
    """
    Uniformly random sequences.
    """
    unlisted: Unlisted | None
    """
    About hazards that are not listed; none if no hazard is, as the share above is then the answer.
    """


class Safeguard(TypedDict):
    """
    A safeguard.
    """

    delay_s: float
    """
    Response time of its own before the FMU is told, s.
    """
    kind: str
    """
    What it is, in words.
    """
    margin_mm: int | None
    """
    How much farther it is than S on the way with the least room, mm; negative where it is nearer. Where something is not known, S
    is the least that it can be.
    """
    moments: list[Stopped]
    """
    What it did at each moment that was tried.
    """
    not_known: list[str]
    """
    What is not known, and why.
    """
    notes: list[str]
    """
    What else there is to say.
    """
    placed: Placed
    """
    Whether it stands far enough away.
    """
    sensor: str
    """
    Name of the sensor.
    """
    stop_s: float | None
    """
    Longest time from when the FMU is told until the robots stand still, s, if it stops them whenever it reports.
    """
    t_s: float | None
    """
    T: both together, s.
    """
    ways: list[ApproachPath]
    """
    The ways past it, that with the least room first.
    """


class SecondRecord(TypedDict):
    """
    A second person.
    """

    also: NotRequired[list[Ability]]
    """
    What they do besides walking, bending and reaching.
    """
    body: NotRequired[BodyRecord | None]
    """
    Their body; older versions did not write it down.
    """
    heading_deg: float
    """
    Where they look then, degrees from +x towards +y.
    """
    held_m: NotRequired[float | None]
    """
    How far what they hold reaches beyond the finger tips, m, if they hold something.
    """
    names: list[str]
    """
    What the first and the second person are called.
    """
    run_m_s: NotRequired[float | None]
    """
    How fast they run, m/s, if they do.
    """
    xy_m: list[float]
    """
    Where the second one begins, floor plan, m.
    """


class SelfTest(TypedDict):
    """
    The outcome of the self-test.
    """

    bytes_per_state: int | None
    """
    Bytes of a serialised state.
    """
    deterministic: Agreement
    """
    Two fresh instances, one after the other, same inputs.
    """
    event_mode: Motion
    """
    The motion of the first run against that of the other of with Event Mode and without.
    """
    fork: Agreement
    """
    The same with copies of the FMU's process as states, for FMUs in workers.
    """
    fresh_process: Agreement
    """
    Two fresh processes, for FMUs in workers.
    """
    half_steps: Motion
    """
    The motion of the first run against that in half steps.
    """
    inputs: int
    """
    Inputs moved and outputs compared.
    """
    output_range: float
    """
    Largest change of any output over the run: zero means that nothing moves.
    """
    outputs: int
    """
    Outputs compared.
    """
    remarks: NotRequired[list[str]]
    """
    What the FMUs said of events in the first run that could not be followed.
    """
    reset: Agreement
    """
    `fmi2Reset` against a fresh instance.
    """
    restore: Agreement
    """
    Restoring a state against the uninterrupted run: two states held, both returned to, the first one twice.
    """
    second_instance: Agreement
    """
    A second instance beside a living first one.
    """
    serialize: Agreement
    """
    A serialised state brought back in another instance.
    """
    step_s: float
    """
    Communication step, s.
    """
    steps: int
    """
    Steps of one run.
    """
    uses_event_mode: bool
    """
    Whether an FMU is run with its Event Mode.
    """


class SeparationTerms(TypedDict):
    """
    The terms of the protective separation distance that the cell file says.
    """

    approach_m_s: float
    """
    Speed at which people approach, m/s.
    """
    intrusion_m: float
    """
    How far a part of the body gets in before the person is seen, m.
    """
    person_uncertainty_m: float
    """
    Uncertainty of where the person is, m.
    """
    robot_uncertainty_m: float
    """
    Uncertainty of where the robot is, m.
    """
    stated: NotRequired[StatedStop | None]
    """
    The figures of a stop that is stated; older versions did not write them down.
    """
    stop: NotRequired[str | None]
    """
    The sensor or input that stops the robots; none if their stop is stated.
    """


class TestedAgainst(TypedDict):
    """
    What a change was held against.
    """

    around: int
    """
    Places around the start from which the person began, too.
    """
    around_complete: bool
    """
    Whether all sequences from there were looked at, else some.
    """
    complete: list[ExhaustiveCheck]
    """
    The complete search from each of the cell's beginnings, the own first.
    """
    counterexamples: int
    """
    Sequences that led to a hazard after smaller changes.
    """
    everywhere: NotRequired[RemedyFromAnywhere | None]
    """
    What came of a search from anywhere, if there was one.
    """
    known_sequences: int
    """
    Sequences of the scan, for all its hazards.
    """
    longest_s: float
    """
    Longest time of known and new sequences that were tried beyond that of the cell file, s.
    """
    one_less: NextSmaller
    """
    What one step less leads to.
    """
    searched: int
    """
    New sequences from the start.
    """


class VerifiedHazard(TypedDict):
    """
    The same for programs.
    """

    cause: str | None
    """
    Id of its cause, if the scan knows causes.
    """
    id: str
    """
    Id of the hazard.
    """
    outcome: VerifiedOutcome
    """
    What became of it.
    """
    ratio: float
    """
    Force relative to the limit, as it was recorded.
    """


Cause = TypedDict(
    'Cause',
    {
        'advice': CauseAdvice | None,
        'class': Class,
        'confirmed': int,
        'earliest_time_s': float,
        'force_n': float,
        'hazards': list[str],
        'id': str,
        'judged': NotRequired[Judged | None],
        'limit_n': float,
        'lines': list[Line],
        'part': BodyOrArm,
        'ratio': float,
        'robot': str,
        'sensors': list[SensorState],
        'sentence': str,
        'sequences': str | None,
        'share': float | None,
        'speed_m_s': NotRequired[float | None],
        'worst': str,
    },
)


class Check(TypedDict):
    """
    What is printed as JSON.
    """

    picture: str | None
    """
    Where the picture is, if the FMU was run.
    """
    probe: Probe | None
    """
    What the FMU did, if it was run and did not fail.
    """
    problems: list[Problem]
    """
    What keeps the cell from being scanned.
    """
    warnings: list[str]
    """
    What else there is to know.
    """


class Comparison(TypedDict):
    """
    Two scans side by side.
    """

    causes: list[CauseChange]
    """
    The causes: new ones first.
    """
    complete: list[bool]
    """
    Whether each of the two is complete: what it did not find is not there, within what it asks.
    """
    counts: dict[str, int]
    """
    How many of each kind.
    """
    hazards: list[HazardChange]
    """
    The hazards: new ones first, then by id.
    """
    inputs: list[str]
    """
    What of the inputs is different, in words.
    """


class CriteriaRecord(TypedDict):
    """
    What counts as unsafe.
    """

    clamping: NotRequired[ClampingRecord | None]
    """
    Clamping.
    """
    moving_contact_faster_than_m_s: NotRequired[float | None]
    """
    Contacts with points of the robot that are faster than this, m/s.
    """
    pressure: bool
    """
    Pressure.
    """
    separation: NotRequired[SeparationTerms | None]
    """
    Separation.
    """
    transient_force: Criterion | None
    """
    The transient force, by this speed; none if it does not count.
    """


class Distances(TypedDict):
    """
    All safeguards of a cell.
    """

    cell: str
    """
    Name of the cell.
    """
    edition: Edition
    """
    Edition of ISO 13855.
    """
    fastest_m_s: float
    """
    Fastest point of any robot while nobody was detected, m/s.
    """
    run_s: float
    """
    How long each run was in which stop times and the robots' reach were measured, s.
    """
    safeguards: list[Safeguard]
    """
    One for each sensor of the cell.
    """
    tables: list[Table]
    """
    Where the figures come from.
    """
    warnings: list[str]
    """
    What else there is to know.
    """


Hazard = TypedDict(
    'Hazard',
    {
        'actions': list[Action],
        'approach_m_s': float,
        'arm': Arm | None,
        'begins': NotRequired[InitialConditionRecord | None],
        'bend_fraction': float,
        'body_point_m': list[float],
        'body_region': BodyRegion,
        'class': Class,
        'confirmed': bool | None,
        'contact_point_m': list[float],
        'directed_force_n': float,
        'directed_ratio': float,
        'distance_m': float,
        'earliest_time_s': float,
        'effective_mass_kg': float,
        'first_contact': NotRequired[FirstContact | None],
        'first_iteration': int,
        'force_n': float,
        'id': str,
        'judged': NotRequired[Judged | None],
        'limit_n': float,
        'person': NotRequired[str | None],
        'person_heading_deg': float,
        'person_xy_m': list[float],
        'phase': int | None,
        'ratio': float,
        'reflected_mass_kg': NotRequired[float | None],
        'robot_link': str,
        'safe_below_m_s': float,
        'sensors': list[SensorState],
        'sequences': str | None,
        'shortest': Shortest,
        'speed_m_s': float,
        'through': list[Through],
        'through_curtain': str | None,
        'through_curtain_s': float | None,
        'time_s': float,
        'times_found': int,
        'worked': NotRequired[list[OperatedControl]],
    },
)


class RemainingHazards(TypedDict):
    """
    What is left after a change.
    """

    at_least: int
    """
    Different hazards of other causes that were met; there may be more.
    """
    checked: TestedAgainst
    """
    What it was held against.
    """
    complete: bool
    """
    Whether every sequence was looked at for hazards that are of no other cause.
    """
    worst: HazardAfterChange | None
    """
    The worst of them, if any was met.
    """


class RemedyOutcomeSufficient(TypedDict):
    """
    Nothing in the cell is hazardous any more: every sequence was looked at.
    """

    sufficient: TestedAgainst


class RemedyOutcomeNotMet(TypedDict):
    """
    No hazard was met, but not everything was looked at.
    """

    not_met: TestedAgainst


class RemedyOutcomeOthersRemain(TypedDict):
    """
    The cause of this hazard is gone, other causes of the scan are not.
    """

    others_remain: RemainingHazards


RemedyOutcome: TypeAlias = RemedyOutcomeSufficient | RemedyOutcomeNotMet | RemedyOutcomeOthersRemain | RemedyOutcomeOnlyLater | RemedyOutcomeNoAdvice | RemedyOutcomeNoHelp | RemedyOutcomeNotTried
"""
What came of a change.
"""


class RiskReduction(TypedDict):
    """
    A change of the cell against a hazard.
    """

    change: str
    """
    The change, in words: the smallest that helps, else the largest that was tried.
    """
    limit: NotRequired[str | None]
    """
    What the cell file allows, if nothing beyond was tried for that reason, and nothing up to there is enough.
    """
    outcome: RemedyOutcome
    """
    What came of it.
    """


class Settings(TypedDict):
    """
    How it was searched.
    """

    action_s: float
    """
    Duration of an action, s.
    """
    actions_per_sequence: int
    """
    Actions in a sequence.
    """
    also: NotRequired[list[Ability]]
    """
    What the person does besides walking, bending and reaching.
    """
    arm_speed_m_s: NotRequired[float | None]
    """
    How fast hands move, m/s, if arms take their time.
    """
    begins: NotRequired[InitialConditionRecord | None]
    """
    Of a scan from a start: where and when the person begins.
    """
    body: NotRequired[BodyRecord | None]
    """
    The person's body.
    """
    contact_check_interval_s: float
    """
    Communication step and contact-check interval, s.
    """
    controls: NotRequired[list[ControlRecord]]
    """
    Controls that the search works.
    """
    criteria: NotRequired[CriteriaRecord | None]
    """
    What counts as unsafe, where that is more or other than the transient force.
    """
    floor_m: NotRequired[list[list[float]] | None]
    """
    Of a scan from anywhere: corners of the floor that people may be on, floor plan, m, if that is bounded.
    """
    held_m: NotRequired[float | None]
    """
    How far what the person holds reaches beyond the finger tips, m, if they hold something.
    """
    iterations: int
    """
    Budget in iterations.
    """
    posture_sweep: bool
    """
    All postures checked per walk.
    """
    presses: NotRequired[int | None]
    """
    Of such a scan: how often controls were worked at most, if the cell has any that are.
    """
    reach_tolerance_m: float
    """
    Depth of contact that the arm check may miss, m.
    """
    run_m_s: NotRequired[float | None]
    """
    How fast who runs does so, m/s.
    """
    second: NotRequired[SecondRecord | None]
    """
    A second person beside them.
    """
    seed: int
    """
    Seed.
    """
    seen_at_start: NotRequired[list[str]]
    """
    Of such a scan: the sensors that see somebody there already; of those inside the FMU it is not known before it runs.
    """
    speed_criterion: Criterion
    """
    Which speed makes the force that decides.
    """
    start_region_m: NotRequired[list[list[float]] | None]
    """
    Of such a scan: corners of the floor from which they come, floor plan, m, if that is not the outside.
    """
    stop_at_first: bool
    """
    Stop at the first hazard instead of using the budget.
    """
    strategy: str
    """
    Strategy name.
    """
    until_s: NotRequired[float | None]
    """
    Of a scan from anywhere: how long after the FMU's own start it looked, s.
    """


class EventHazard(TypedDict):
    """
    A hazard was found. It is not confirmed yet: what counts stands in the results.
    """

    event: Literal['hazard']
    hazard: Hazard
    """
    As in hazards.jsonl.
    """


Event: TypeAlias = EventDoing | EventProgress | EventHazard | EventResults | EventNote | EventWarning | EventError
"""
A line on standard error with `--progress json`. There may be other lines: what the system says, or a mistake in the options.
"""


class Explanation(TypedDict):
    """
    Everything that is told about a hazard.
    """

    action_s: float
    """
    Duration of an action, s.
    """
    begins_s: float
    """
    When the person starts, s after the FMU.
    """
    hazard: Hazard
    """
    The hazard.
    """
    outside: list[Outside]
    """
    How far the person stands outside the zones of sensors that do not report anybody.
    """
    remedies: list[RiskReduction]
    """
    What was tried against it; empty if nothing was.
    """
    robot: Robot
    """
    The robot that hits.
    """
    second: NotRequired[SecondRecord | None]
    """
    A second person, if there is one.
    """
    sensors: list[Reports]
    """
    What the sensors report on the way.
    """
    start: tuple[StartItem, float]
    """
    Where the person starts, floor plan, m, and looks, degrees from +x towards +y.
    """


class ScanReport(TypedDict):
    """
    A whole scan.
    """

    causes: list[Cause]
    """
    What is wrong with the cell: hazards that belong together, worst first.
    """
    certificate: Certificate | None
    """
    What an exhaustive search covered.
    """
    coverage: Coverage
    """
    What was seen.
    """
    cycle: NotRequired[CycleShare | None]
    """
    How much of the robots' cycle a search from the start met; none if the search was stopped before that was asked, or is one from
    anywhere. The run that this takes is not counted in `spent`.
    """
    faults: list[FaultRecord]
    """
    Actions that the FMU could not finish, with the sequences that lead there.
    """
    hazards: list[Hazard]
    """
    Hazards, worst first.
    """
    headline: Headline
    """
    The verdict and what it is about, in words.
    """
    obligations: Obligations
    """
    What the result rests on: everything that "nobody is hit" needs, shown, assumed or open.
    """
    residual: Residual | None
    """
    What random sequences say about what is left; none if every sequence was looked at, if the strategy keeps no
    random sequences apart, or if the search ended early, because of what it met or by wish.
    """
    schema_version: int
    """
    [`SCHEMA_VERSION`].
    """
    self_test: SelfTest
    """
    The state self-test.
    """
    settings: Settings
    """
    How it was searched.
    """
    speeds: NotRequired[list[SpeedRecord]]
    """
    Speeds that the FMU tells and that are not those of the motion: with any of them nothing is certified.
    """
    spent: Spent
    """
    What it cost.
    """
    standard_edition: str
    """
    Edition of the limits.
    """
    subject: Subject
    """
    What was scanned.
    """
    tables: list[Table]
    """
    Tables of figures used, each with source, confidence and whether a person has verified it.
    """
    tool: str
    """
    Name and version of this tool.
    """
    verdict: Verdict
    """
    Overall outcome.
    """
    warnings: list[str]
    """
    Things the user should know.
    """


class Commands(TypedDict):
    """
    Each property is what the command of this name prints with `--format json`, but for the last three.
    """

    anywhere: ReachabilityResult
    """
    anywhere.json, which a scan from anywhere writes, and prints when it is asked for nothing else.
    """
    check: Check
    """
    `check`.
    """
    compare: Comparison
    """
    `compare`.
    """
    distance: Distances
    """
    `distance`.
    """
    explain: Explanation
    """
    `explain`.
    """
    progress: Event
    """
    A line on standard error of any command with `--progress json`.
    """
    replay: list[ReplayedHazard]
    """
    `replay`: an entry a hazard.
    """
    replay_changed: list[VerifiedHazard]
    """
    `replay --changed`: a row a hazard.
    """
    scan: ScanReport
    """
    `scan`: scan.json, as in the schema of its own.
    """
