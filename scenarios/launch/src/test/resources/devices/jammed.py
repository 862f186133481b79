"""A vending machine whose flap is jammed: it says that it has sold, and its state still has the can."""
import sys

import rats

machine = rats.Device(
    "vending-1", namespace="https://example.org/vending#", label="the machine",
    classes={"Can": "domain:Item"},
    words=[rats.word("stocked", "?c - Can", "?d - Device"), rats.word("sold", "?c - Can", "?p - Person")])


@machine.feature("sell", inputs={"can": "Can", "buyer": "domain:Person"}, cost=1, seconds=0.2, tries=1,
                 precondition="(stocked ?can ?self)",
                 effect="(and (sold ?can ?buyer) (not (stocked ?can ?self)))")
def sell(call, can, buyer):
    print("JAMMED", can, flush=True)


machine.tell("(Can can-1)", "(stocked can-1 vending-1)")
machine.run(sys.argv[1], int(sys.argv[2]), sys.argv[3])
