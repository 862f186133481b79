"""The tea kettle of docs/examples, on the package: python3 kettle.py HOST PORT SITE [FOLDER]."""
import logging
import sys

import rats

logging.basicConfig(level=logging.WARNING)
kettle = rats.Device(
    "kettle-1", namespace="https://example.org/kitchen#", label="the kettle", type="Kettle",
    classes={"Kettle": "maestro:Device", "Drink": "maestro:Thing"},
    words=[rats.word("served", "?drink - Drink", "?guest - Person", label="served to")],
    things=[rats.Thing("tea", "Drink")])


@kettle.feature("brew", inputs={"drink": "Drink", "guest": "domain:Person"}, occupies=["pot"],
                effect="(served ?drink ?guest)", cost=3, seconds=0.2,
                sentence="{self} brews {drink} for {guest}")
def brew(call, drink, guest):
    call.sleep(0.2)
    kettle.tell(f"(served {drink} {guest})")


kettle.run(sys.argv[1], int(sys.argv[2]), sys.argv[3], sys.argv[4] if len(sys.argv) > 4 else None)
