"""A drier of which somebody opens the door while it runs."""
import sys
import threading

import rats

drier = rats.Device("drier-1", namespace="https://example.org/driers#", label="the drier",
                    type="Drier", classes={"Drier": "maestro:Device"},
                    words=[rats.word("dry", "?d - Drier", observable=True),
                           rats.word("shut", "?d - Drier", observable=True)])


@drier.feature("tumble", effect="(dry ?self)", cost=2, seconds=30, meanwhile="(shut ?self)",
               sentence="{self} tumbles")
def tumble(call):
    print("TUMBLE", flush=True)
    threading.Timer(0.5, drier.untell, ("(shut drier-1)",)).start()
    try:
        call.sleep(30)
    finally:
        print("STOPPED", flush=True)


drier.tell("(shut drier-1)")
drier.run(sys.argv[1], int(sys.argv[2]), sys.argv[3])
