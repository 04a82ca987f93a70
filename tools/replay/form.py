"""The members that a certificate of each kind has: whatever else stood in one would be said without being proved."""
from replay.flow import must
from replay.table import Unserved

TOP = {"certificate", "kind", "theorem", "given", "shown"}
ORBIT = ({"table", "parameters", "levels", "digits", "section", "coordinates", "legs"},
         {"orbit", "period", "determinant", "determinant_of_matrix", "trace", "multipliers", "conditions", "claims"})
MEMBERS = {
    "equilibria": ({"table", "family", "box", "limit", "digits"}, {"trace", "conditions", "boxes", "point", "claims"}),
    "pole": ({"table", "parameters", "box", "digits", "pole", "time", "instant"},
             {"end", "vanish", "limit", "time", "conditions", "claims"}),
    "cycle": ORBIT,
    "obstruction": ORBIT,
    "sink": ORBIT,
    "symmetric": (ORBIT[0], ORBIT[1] | {"symmetry"}),
    "elliptic": (ORBIT[0], ORBIT[1] | {"symmetry", "twist"}),
}
REVERSORS = {"sink": ([], ["reversor"]), "symmetric": (["reversor"],), "elliptic": (["reversor"],)}  # claimed beside levels


def has(part, names, what):
    must(set(part) == set(names), "%s has other members than those that are replayed" % what)


def check(certificate, table):
    """That a certificate has these members, and rests on the claims that one of its kind rests on."""
    kind, given, shown = certificate["kind"], certificate["given"], certificate["shown"]
    if kind not in MEMBERS:
        raise Unserved("it is of kind " + kind)
    has(certificate, TOP, "it")
    must(certificate["certificate"] == "jellett 1", "it has another form")
    for name, members in zip(("given", "shown"), MEMBERS[kind]):
        has(certificate[name], members, name)
    has(given["table"], ("name", "sha256"), "table")
    has(shown["conditions"], table.valids, "conditions")
    if kind == "equilibria":
        allowed = [["equilibria " + given["family"], "trace " + given["family"]], ["equilibria " + given["family"]]]
    elif kind == "pole":
        allowed = [["pole " + given["pole"]]]
    else:
        check_orbit(given, shown, [s for s in table.states if s != given["section"]["state"]])
        allowed = [["integral " + name for name in given["levels"]] + more for more in REVERSORS.get(kind, ([],))]
    must(shown["claims"] in allowed, "it says to rest on other claims")


def check_orbit(given, shown, others):
    has(given["section"], ("state", "value", "direction"), "section")
    must(given["section"]["direction"] in (1, -1), "the section is crossed in no direction")
    must(list(given["coordinates"]) == [s for s in others if s in given["coordinates"]], "its coordinates are not the table's")
    for leg in given["legs"]:
        if "turns" in leg:
            raise Unserved("the orbit closes up to periods of states")
        has(leg, ("box", "instant"), "a leg")
        has(leg["box"], others, "a box")
    for point in shown["orbit"]:
        has(point, others, "a point")
    if "symmetry" in shown:
        has(shown["symmetry"], ["type", "reversor"] + ["rotation"] * (shown["symmetry"]["type"] == "elliptic"), "symmetry")
    if "twist" in shown:
        has(shown["twist"], ("coordinate", "coefficient", "growth"), "twist")
    for multiplier in shown["multipliers"]:
        has(multiplier, ("re", "im"), "a multiplier")
