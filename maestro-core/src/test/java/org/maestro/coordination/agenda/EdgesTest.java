package org.maestro.coordination.agenda;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.maestro.sl.Truth;

/** What becomes so is found once, each time. */
class EdgesTest {
  private final Edges<String> edges = new Edges<>();
  private final Map<String, Truth> truths = new TreeMap<>();

  private List<String> look() {
    return edges.look(holding(truths), truth(truths));
  }

  private static List<String> holding(Map<String, Truth> truths) {
    return truths.keySet().stream().filter(one -> truths.get(one) == Truth.TRUE).toList();
  }

  private static Function<String, Truth> truth(Map<String, Truth> truths) {
    return one -> truths.getOrDefault(one, Truth.FALSE);
  }

  @Test
  void whatIsSoStillHasNotBecomeSo() {
    truths.put("hot", Truth.TRUE);
    assertThat(look()).containsExactly("hot");
    assertThat(look()).isEmpty();

    truths.put("hot", Truth.FALSE);
    assertThat(look()).isEmpty();
    truths.put("hot", Truth.TRUE);
    assertThat(look()).containsExactly("hot");
  }

  @Test
  void whatIsNotKnownAnyMoreIsNotSo() {
    truths.put("hot", Truth.TRUE);
    look();
    truths.put("hot", Truth.UNKNOWN);
    look();
    truths.put("hot", Truth.TRUE);

    assertThat(look()).containsExactly("hot");
  }

  @Test
  void whoIsLostAndComesBackHasNoNews() {
    truths.put("hot", Truth.TRUE);
    look();
    truths.put("hot", Truth.UNKNOWN);
    edges.lost(truth(truths));
    assertThat(look()).isEmpty();
    assertThat(edges.so()).containsExactly("hot");
    truths.put("hot", Truth.TRUE);
    assertThat(look()).isEmpty();

    truths.put("hot", Truth.UNKNOWN);
    edges.lost(truth(truths));
    truths.put("hot", Truth.FALSE);
    assertThat(look()).isEmpty();
    truths.put("hot", Truth.TRUE);
    assertThat(look()).containsExactly("hot");
  }

  @Test
  void whatWasSoBeforeARestartIsSoUntilItIsKnownNotToBe() {
    edges.resume(List.of("hot", "open"));
    truths.put("hot", Truth.UNKNOWN);
    truths.put("open", Truth.FALSE);
    assertThat(look()).isEmpty();
    truths.put("hot", Truth.TRUE);
    truths.put("open", Truth.TRUE);

    assertThat(look()).containsExactly("open");
  }

  @Test
  void whatIsPutOffIsFoundAgain() {
    truths.put("hot", Truth.TRUE);
    look();
    edges.putOff("hot");

    assertThat(look()).containsExactly("hot");
  }

  /** Found as often as it goes from not so to so. */
  @Property(tries = 200)
  void asManyAsThereAreEdges(@ForAll @Size(max = 40) List<Boolean> course) {
    Edges<String> found = new Edges<>();
    List<String> all = new ArrayList<>();
    int expected = 0;
    boolean before = false;
    for (boolean now : course) {
      expected += now && !before ? 1 : 0;
      before = now;
      Set<String> holding = now ? Set.of("hot") : Set.of();
      all.addAll(found.look(holding, one -> Truth.of(now)));
      assertThat(found.so()).isEqualTo(new LinkedHashSet<>(holding));
    }
    assertThat(all).hasSize(expected);
  }
}
