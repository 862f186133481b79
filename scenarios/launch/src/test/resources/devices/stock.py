"""A vending machine that tells which cans are in it; who has bought one is told by nobody but the sale."""
import sys

import rats

stock = ["can-1", "can-2"]
machine = rats.Device(
    "vending-1", namespace="https://example.org/vending#", label="the machine",
    classes={"Can": "domain:Item"},
    words=[rats.word("stocked", "?c - Can", "?d - Device"), rats.word("sold", "?c - Can", "?p - Person")])


def tell():
    machine.tell(*[fact for can in stock for fact in (f"(Can {can})", f"(stocked {can} vending-1)")],
                 instead_of=machine.values)


@machine.feature("sell", inputs={"can": "Can", "buyer": "domain:Person"}, cost=1, seconds=0.2,
                 precondition="(stocked ?can ?self)",
                 effect="(and (sold ?can ?buyer) (not (stocked ?can ?self)))")
def sell(call, can, buyer):
    if can not in stock:
        print("EMPTY", flush=True)
        raise rats.Refused("There is no " + can)
    stock.remove(can)
    print("SOLD", can, flush=True)
    tell()


tell()
machine.run(sys.argv[1], int(sys.argv[2]), sys.argv[3])
