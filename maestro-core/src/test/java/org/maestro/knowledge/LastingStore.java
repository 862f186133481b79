package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Store;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What a store that outlives its process has to remember, with no other file. */
final class LastingStore {
  private LastingStore() {}

  static void rememberOverARestart(Store store) {
    Household before = new Household(store);
    before.knowledge.describe(Household.device(Household.individual("lamp-that-left", "Device")));
    before.state(Household.CAMERA, "(in Cup zone-a)", "(= (illuminance zone-a) 80.5)");
    before.state(Household.CAMERA, "(in Cup zone-b)", "(not (in Bob zone-b))");
    before.close();

    Household after = new Household(store);
    assertThat(after.truth("(in Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
    assertThat(after.number("(illuminance zone-a)")).isEmpty();
    assertThat(after.knowledge.history("(in Cup zone-b)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-a)", "(in Cup zone-b)");
    assertThat(after.knowledge.history("(in Cup zone-b)"))
        .extracting(Belief::source)
        .containsOnly(Household.CAMERA);
    assertThat(after.knowledge.snapshot().lastKnown("in", List.of(new Term.Name("Cup"))))
        .map(Belief::fact)
        .contains("(in Cup zone-b)");
    assertThat(
            after.knowledge.select(
                "SELECT ?s WHERE { GRAPH <https://example.org/home#graph/member/lamp-that-left>"
                    + " { ?s ?p ?o } }"))
        .isEmpty();
    after.state(Household.CAMERA, "(in Cup rose)");
    after.close();

    Household third = new Household(store);
    assertThat(third.knowledge.history("(in Cup zone-b)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-a)", "(in Cup zone-b)", "(in Cup rose)");
    third.close();
  }
}
