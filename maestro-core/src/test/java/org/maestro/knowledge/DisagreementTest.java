package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Sources that disagree: the stated rule settles it, and the loser stays visible (Three-layered
 * architecture, 2; M10).
 */
class DisagreementTest {

  private static final Source CAM_A = new Source(Source.Kind.OBSERVED, "cam-a");
  private static final Source CAM_B = new Source(Source.Kind.OBSERVED, "cam-b");
  private static final Source CAM_C = new Source(Source.Kind.OBSERVED, "cam-c");
  private static final Source ROSE = new Source(Source.Kind.OBSERVED, "rose");

  private final Household home = new Household(store());

  /** Where the dataset is kept. */
  Store store() {
    return Store.IN_MEMORY;
  }

  @AfterEach
  void close() {
    home.close();
  }

  @Test
  void ofEquallySureSourcesTheLaterReceivedCounts() {
    home.state(CAM_A, "(position Cup \"1 0 0\")");
    home.pass(Duration.ofSeconds(1));
    home.state(CAM_B, "(position Cup \"4 0 0\")");

    assertThat(position()).isEqualTo("4 0 0");
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
    Dispute dispute = dispute("position");
    assertThat(dispute.believed()).map(Belief::source).contains(CAM_B);
    assertThat(dispute.losers())
        .extracting(loser -> loser.belief().source(), Dispute.Loser::rule)
        .containsExactly(tuple(CAM_A, Dispute.Rule.LATER));
  }

  /** A look from before the grasp may be heard after it, when messages were held up. */
  @Test
  void whatADeviceGoesOnSayingOfItselfCountsAgainWhenTheOtherTakesBackItsWord() {
    home.state(CAM_B, "(position Cup \"4 0 0\")", "(canSee cam-b Cup)");
    home.state(Household.ROBOT, "(in rose zone-b)", "(in Cup rose)");
    home.state(CAM_B, "(position Cup \"4 0 0\")", "(canSee cam-b Cup)");
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);

    home.state(CAM_B, "(not (canSee cam-b Cup))", "(not (in Cup zone-b))");

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatADeviceDoesNotSayAnyMoreDoesNotComeBack() {
    home.state(Household.ROBOT, "(in rose zone-b)", "(in Cup rose)");
    home.state(CAM_B, "(position Cup \"4 0 0\")", "(canSee cam-b Cup)");
    home.state(Household.ROBOT, "(in rose zone-b)");

    home.state(CAM_B, "(not (canSee cam-b Cup))", "(not (in Cup zone-b))");

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void theSurerSourceCountsThoughTheOtherSpokeLater() {
    describe("cam-b", 0.6);
    home.state(CAM_A, "(position Cup \"1 0 0\")");
    home.pass(Duration.ofSeconds(1));
    home.state(CAM_B, "(position Cup \"4 0 0\")");

    assertThat(position()).isEqualTo("1 0 0");
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.TRUE);
    Dispute dispute = dispute("position");
    assertThat(dispute.losers())
        .extracting(
            loser -> loser.belief().fact(),
            loser -> loser.belief().confidence(),
            Dispute.Loser::rule)
        .containsExactly(tuple("(position Cup \"4 0 0\")", 0.6, Dispute.Rule.SURER));
    assertThat(home.knowledge.history("(position Cup \"0 0 0\")"))
        .extracting(belief -> belief.source().agent())
        .containsExactly("cam-a", "cam-b");
  }

  @Test
  void withinOneSourceTheNewerCountsAndIsNoDispute() {
    home.state(CAM_A, "(position Cup \"1 0 0\")");
    home.state(CAM_A, "(position Cup \"2 0 0\")");

    assertThat(position()).isEqualTo("2 0 0");
    assertThat(home.knowledge.snapshot().disputes()).isEmpty();
  }

  @Test
  void whatTheLessSureSourceSaidCountsWhenTheSurerIsTooOldOrTakesItBack() {
    describe("cam-b", 0.6);
    home.state(CAM_A, "(position Bob \"1 0 0\")", "(in Cup zone-a)");
    home.pass(Duration.ofSeconds(20));
    home.state(CAM_B, "(position Bob \"4 0 0\")", "(in Cup zone-b)");
    assertThat(home.truth("(and (in Bob zone-a) (in Cup zone-a))")).isEqualTo(Truth.TRUE);

    home.pass(Duration.ofSeconds(11));
    home.state(CAM_A, "(not (in Cup zone-a))");

    assertThat(home.truth("(in Bob zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatWasOverruledDoesNotComeBack() {
    home.state(CAM_A, "(in Cup zone-a)");
    home.state(CAM_B, "(in Cup zone-b)");
    home.state(CAM_B, "(not (in Cup zone-b))");

    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void threeSourcesAreSettledTheSameWay() {
    describe("cam-b", 0.6);
    describe("cam-c", 0.8);
    home.state(CAM_A, "(in Cup zone-a)");
    home.state(CAM_B, "(in Cup zone-b)");
    home.state(CAM_C, "(in Cup rose)");

    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.TRUE);
    assertThat(dispute("in").losers())
        .extracting(loser -> loser.belief().source(), Dispute.Loser::rule)
        .containsExactly(tuple(CAM_C, Dispute.Rule.SURER), tuple(CAM_B, Dispute.Rule.SURER));

    home.state(CAM_A, "(not (in Cup zone-a))");

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatIsSeenCountsMoreThanWhatWasExpectedHoweverUnsureTheSource() {
    describe("cam-b", 0.1);
    home.state(new Source(Source.Kind.EXPECTED, "rose"), "(in Cup zone-a)");
    home.pass(Duration.ofSeconds(1));
    home.state(CAM_B, "(in Cup zone-b)");

    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(dispute("in").losers())
        .extracting(Dispute.Loser::rule)
        .containsExactly(Dispute.Rule.SEEN);
  }

  @Test
  void aStepOutdatesWhatEveryoneSaidBefore() {
    home.state(CAM_A, "(in Cup zone-a)");
    home.state(CAM_B, "(in Cup zone-b)");
    home.pass(Duration.ofSeconds(1));
    home.state(new Source(Source.Kind.EXPECTED, "rose"), "(in Cup rose)");

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
    assertThat(home.knowledge.snapshot().disputes()).isEmpty();
  }

  @Test
  void aNumberReckonedForwardFromASureReadingStandsAgainstAnUnsureOne() {
    describe("cam-b", 0.4);
    home.state(CAM_A, "(= (illuminance zone-b) 40)");
    home.state(new Source(Source.Kind.EXPECTED, "lamp-b1"), "(= (illuminance zone-b) 80)");
    home.state(CAM_B, "(= (illuminance zone-b) 55)");
    assertThat(home.number("(illuminance zone-b)")).hasValue(80);

    home.state(ROSE, "(= (illuminance zone-b) 70)");

    assertThat(home.number("(illuminance zone-b)")).hasValue(70);
  }

  @Test
  void expiryIsToldWithoutAnybodyAsking() {
    List<List<String>> told = new ArrayList<>();
    home.state(CAM_A, "(position Bob \"1 0 0\")");
    home.knowledge.watch(change -> told.add(change.facts()));

    home.pass(Duration.ofSeconds(31));

    assertThat(told).hasSize(1);
    assertThat(told.get(0))
        .contains("(unknown (in Bob zone-a))", "(unknown (position Bob \"1 0 0\"))");
    assertThat(home.knowledge.snapshot().lastKnown("in", List.of(new Term.Name("Bob"))))
        .map(Belief::fact)
        .contains("(in Bob zone-a)");
  }

  @Test
  void aReaderCanAskForNothingOlder() {
    home.state(CAM_A, "(in Cup zone-a)");
    home.pass(Duration.ofSeconds(60));
    home.state(CAM_A, "(not (in Bob zone-b))");
    Snapshot all = home.knowledge.snapshot();
    Snapshot recent = all.notOlderThan(Duration.ofSeconds(59));

    assertThat(all.beliefs()).hasSize(2);
    assertThat(recent.beliefs()).extracting(Belief::fact).containsExactly("(not (in Bob zone-b))");
    assertThat(recent.individuals("Thing")).isNotEmpty();
    assertThat(all.beliefs().get(0).age(all.at())).isEqualTo(Duration.ofSeconds(60));
  }

  private void describe(String camera, double confidence) {
    Individual individual = Household.individual(camera, "Device");
    Map<String, List<Term>> properties = new TreeMap<>(individual.properties());
    properties.put("confidence", List.of(new Term.Number(confidence)));
    home.knowledge.describe(
        Household.device(
            new Individual(camera, individual.iri(), camera, individual.classes(), properties)));
  }

  private String position() {
    return home.knowledge
        .snapshot()
        .value("position", List.of(new Term.Name("Cup")))
        .map(term -> ((Term.Text) term).value())
        .orElse("");
  }

  private Dispute dispute(String predicate) {
    return home.knowledge.snapshot().disputes().stream()
        .filter(dispute -> dispute.believed().orElseThrow().fact().startsWith("(" + predicate))
        .findFirst()
        .orElseThrow();
  }
}
