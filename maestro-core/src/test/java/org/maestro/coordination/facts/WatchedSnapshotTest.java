package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/** What nobody goes on observing is not known to who has to rely on it. */
class WatchedSnapshotTest {
  private static final Expression.Fluent LIGHT = KnownHome.fluent("(illuminance zone-b)");

  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final Formula.Atom cup = home.atom("(in Cup zone-b)");

  private Snapshot watched(boolean watched) {
    return new WatchedSnapshot(
        home.now(),
        home.vocabulary,
        Set.of("in", "illuminance"),
        atom -> watched,
        fluent -> watched);
  }

  @Test
  void whatNobodyWatchesIsUnknown() {
    Snapshot unwatched = watched(false);

    assertThat(unwatched.truth(cup)).isEqualTo(Truth.UNKNOWN);
    assertThat(unwatched.belief(cup)).isEmpty();
    assertThat(unwatched.claims(cup)).isEmpty();
    assertThat(unwatched.number(LIGHT)).isEmpty();
    assertThat(unwatched.belief(LIGHT)).isEmpty();
    assertThat(unwatched.claims(LIGHT)).isEmpty();
  }

  @Test
  void whatSomebodyWatchesIsKnown() {
    Snapshot watched = watched(true);

    assertThat(watched.truth(cup)).isEqualTo(Truth.TRUE);
    assertThat(watched.belief(cup)).isEqualTo(home.now().belief(cup)).isPresent();
    assertThat(watched.claims(cup)).isEqualTo(home.now().claims(cup)).isNotEmpty();
    assertThat(watched.number(LIGHT)).hasValue(17);
    assertThat(watched.belief(LIGHT)).isEqualTo(home.now().belief(LIGHT)).isPresent();
    assertThat(watched.claims(LIGHT)).isEqualTo(home.now().claims(LIGHT)).isNotEmpty();
  }

  @Test
  void whatADeviceSaysOfItselfNeedsNoObserver() {
    assertThat(watched(false).truth(home.atom("(in rose zone-b)"))).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatCannotBeWatchedIsKnownAsItIs() {
    assertThat(watched(false).truth(home.atom("(open door-ab)"))).isEqualTo(Truth.TRUE);
    assertThat(watched(false).number(KnownHome.fluent("(level lamp-b1)"))).hasValue(0);
  }

  @Test
  void whatIsDerivedFollowsFromWhatIsWatched() {
    assertThat(watched(true).truth(home.atom("(handFree rose)"))).isEqualTo(Truth.TRUE);
    assertThat(watched(false).truth(home.atom("(handFree rose)")))
        .as("nobody knows whether the cup is in the hand")
        .isEqualTo(Truth.FALSE);
    assertThat(watched(false).truth(home.atom("(passable zone-a zone-b)"))).isEqualTo(Truth.TRUE);
  }

  @Test
  void olderAndWitnessedOnesHideTheSame() {
    home.pass(Duration.ofSeconds(10));
    List<Belief> witnessed = new ArrayList<>();

    assertThat(watched(false).notOlderThan(Duration.ofMinutes(1)).number(LIGHT)).isEmpty();
    assertThat(watched(true).notOlderThan(Duration.ofMinutes(1)).number(LIGHT)).hasValue(17);
    assertThat(watched(true).notOlderThan(Duration.ofSeconds(1)).number(LIGHT)).isEmpty();
    assertThat(watched(false).witnessed(witnessed::add).truth(cup)).isEqualTo(Truth.UNKNOWN);
    assertThat(witnessed).extracting(Belief::fact).doesNotContain("(= (illuminance zone-b) 17)");
    assertThat(watched(true).witnessed(witnessed::add).number(LIGHT)).hasValue(17);
    assertThat(witnessed).extracting(Belief::fact).contains("(= (illuminance zone-b) 17)");
  }

  @Test
  void theRestIsTheSameMoment() {
    Snapshot now = home.now();
    Snapshot watched = watched(false);

    assertThat(watched.version()).isEqualTo(now.version()).isPositive();
    assertThat(watched.at()).isEqualTo(now.at());
    assertThat(watched.individuals("Item")).isEqualTo(now.individuals("Item")).isNotEmpty();
    assertThat(watched.beliefs()).isEqualTo(now.beliefs()).isNotEmpty();
    assertThat(watched.disputes()).isEqualTo(now.disputes());
    assertThat(watched.value("in", List.of(SlParser.term("rose"))))
        .contains(SlParser.term("zone-b"));
    assertThat(watched.lastKnown("in", List.of(SlParser.term("Cup"))))
        .isEqualTo(now.lastKnown("in", List.of(SlParser.term("Cup"))))
        .isPresent();
  }
}
