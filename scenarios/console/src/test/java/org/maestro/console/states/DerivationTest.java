package org.maestro.console.states;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.rats.protocol.MemberStatus;

/** What depends on something is no better than that, and says so. */
class DerivationTest {
  private static final Observed.Agent ROSE =
      new Observed.Agent("rose", "robots", List.of("rose"), true);
  private static final Observed.Agent LAMP =
      new Observed.Agent("lamp", "lights", List.of("lamp"), true);

  private static Observed.Container container(String name, Condition condition) {
    return new Observed.Container(name, "here", true, condition, Duration.ZERO, List.of());
  }

  private static Observed observed(
      Optional<String> bus,
      Condition robots,
      Map<String, Condition> idle,
      Map<String, MemberStatus.Phase> phases,
      Map<String, String> refused,
      Set<String> homeless) {
    return new Observed(
        bus,
        Optional.of("The disk is full."),
        true,
        HeartbeatSettings.standard(),
        List.of(container("robots", robots), container("lights", Condition.ALIVE)),
        List.of(),
        List.of(ROSE, LAMP),
        idle,
        phases,
        refused,
        homeless);
  }

  private static final Map<String, MemberStatus.Phase> READY =
      Map.of("rose", MemberStatus.Phase.READY, "lamp", MemberStatus.Phase.READY);

  private static Derivation with(Condition robots) {
    return new Derivation(observed(Optional.empty(), robots, Map.of(), READY, Map.of(), Set.of()));
  }

  @Test
  void aDoubtedOrLostContainerMakesItsAgentsDoubtfulAndTheirMembersUnreachable() {
    assertThat(with(Condition.ALIVE).member("rose", ROSE)).isEqualTo(Derived.WELL);
    for (Condition condition : List.of(Condition.SUSPECTED, Condition.LOST)) {
      Derivation derivation = with(condition);
      String inWords = condition == Condition.LOST ? "lost" : "doubtful";

      assertThat(derivation.container(container("robots", condition)).why().orElseThrow())
          .contains("no sign of life for " + (condition == Condition.LOST ? "4 s" : "2 s"));
      assertThat(derivation.agent(ROSE))
          .isEqualTo(Derived.of(Standing.DOUBTFUL, "Its container robots is " + inWords + "."));
      assertThat(derivation.member("rose", ROSE))
          .isEqualTo(
              Derived.of(
                  Standing.UNREACHABLE,
                  "Its agent rose is doubtful: Its container robots is " + inWords + "."));
      assertThat(derivation.member("lamp", LAMP)).isEqualTo(Derived.WELL);
    }
  }

  @Test
  void aLostBusMakesAllMembersUnreachableAndNoAgentDoubtful() {
    Derivation derivation =
        new Derivation(
            observed(
                Optional.of("There is no connection to the bus (refused)."),
                Condition.ALIVE,
                Map.of(),
                READY,
                Map.of(),
                Set.of()));

    assertThat(derivation.bus().standing()).isEqualTo(Standing.LOST);
    assertThat(derivation.agent(LAMP)).isEqualTo(Derived.WELL);
    assertThat(List.of(derivation.member("rose", ROSE), derivation.member("lamp", LAMP)))
        .allMatch(one -> one.standing() == Standing.UNREACHABLE);
  }

  @Test
  void whoDoesNothingWhoIsRefusedAndWhoHasLeftAreNotWell() {
    Derivation derivation =
        new Derivation(
            observed(
                Optional.empty(),
                Condition.ALIVE,
                Map.of("rose", Condition.SUSPECTED),
                Map.of("lamp", MemberStatus.Phase.LOST),
                Map.of(),
                Set.of("rose")));

    assertThat(derivation.agent(ROSE).why())
        .contains("It does nothing, though its container lives.");
    assertThat(derivation.member("lamp", LAMP).standing()).isEqualTo(Standing.LOST);
    assertThat(derivation.agent(new Observed.Agent("rose", "robots", List.of("rose"), false)))
        .isEqualTo(Derived.of(Standing.LOST, "No host that is there provides what it needs."));
    assertThat(derivation.journal()).isEqualTo(Derived.of(Standing.FAILING, "The disk is full."));
    Derivation refused =
        new Derivation(
            observed(
                Optional.empty(),
                Condition.ALIVE,
                Map.of(),
                READY,
                Map.of("lamp", "It has no name."),
                Set.of()));
    assertThat(refused.member("lamp", LAMP))
        .isEqualTo(
            Derived.of(Standing.FAILING, "What it says of itself is refused: It has no name."));
  }
}
