package org.maestro.deployment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Where agents belong, and what speaks against it (Three-layered architecture, 3.3.2; M68-M72). */
class DeploymentTest {
  private static final Optional<String> NOWHERE_NAMED = Optional.empty();

  private final Deployment deployment = new Deployment();

  @Test
  void anAgentBeginsInTheContainerOfItsTopicAlsoIfNobodyHasHeardOfTheTopic() {
    assertThat(deployment.containerFor(NOWHERE_NAMED, "fridges", Set.of())).isEqualTo("fridges");
  }

  @Test
  void whoJoinsForATopicGetsItsAgentsUntilItIsGone() {
    own("robots");
    deployment.containerThere(new ContainerStart("lab", Set.of("robots"), Set.of(), false));
    assertThat(deployment.containerFor(NOWHERE_NAMED, "robots", Set.of())).isEqualTo("lab");

    deployment.containerGone("lab");
    assertThat(deployment.containerFor(NOWHERE_NAMED, "robots", Set.of())).isEqualTo("robots");
  }

  @Test
  void anAgentBeginsWhereItsNeedsAreProvided() {
    own("voices");
    deployment.containerThere(
        new ContainerStart("kitchen", Set.of(), Set.of("microphone", "gpu"), false));

    assertThat(deployment.containerFor(NOWHERE_NAMED, "voices", Set.of("microphone")))
        .isEqualTo("kitchen");
    assertThatThrownBy(() -> deployment.containerFor(NOWHERE_NAMED, "voices", Set.of("lidar")))
        .hasMessage(
            "No container provides lidar; join one with ./maestro container --provides lidar.");
    assertThatThrownBy(
            () -> deployment.containerFor(Optional.of("voices"), "voices", Set.of("gpu")))
        .hasMessage("The container voices does not provide gpu.");
  }

  /** What it was configured with since goes with it when its host is lost. */
  @Test
  void whoBeginsOnAnotherHostIsConfiguredAsItWasLast() {
    AgentStart start = AgentStart.of("lamp-1", "lights");
    deployment.placed(start);
    deployment.placed(
        start.with(List.of(new Charge("lamp-1", Optional.of("<#lamp-1> a :Lamp .")))));
    deployment.moved("lamp-1", "cellar");
    deployment.containerGone("cellar");

    AgentStart elsewhere = deployment.require("lamp-1").in("attic");
    assertThat(elsewhere.container()).isEqualTo("attic");
    assertThat(elsewhere.charges())
        .containsExactly(new Charge("lamp-1", Optional.of("<#lamp-1> a :Lamp .")));
  }

  @Test
  void nothingIsTheAgentOfADeviceTwice() {
    deployment.placed(AgentStart.of("lamp-1", "lights"));

    assertThatThrownBy(() -> deployment.requireNew(AgentStart.of("lamp-1", "lights")))
        .hasMessageContaining("There is an agent lamp-1 already, in lights");
    AgentStart two =
        new AgentStart(
            "ceiling",
            List.of(new Charge("lamp-1", Optional.empty()), new Charge("lamp-2", Optional.empty())),
            "lights",
            Set.of(),
            "lights");
    assertThatThrownBy(() -> deployment.requireNew(two))
        .hasMessageContaining("The agent lamp-1 stands for lamp-1 already");

    deployment.dismissed("lamp-1");
    assertThatCode(() -> deployment.requireNew(two)).doesNotThrowAnyException();
  }

  @Test
  void oneAgentMayStandForSeveralDevices() {
    deployment.placed(
        new AgentStart(
            "ceiling",
            List.of(new Charge("lamp-1", Optional.empty()), new Charge("lamp-2", Optional.empty())),
            "lights",
            Set.of(),
            "lights"));

    assertThat(deployment.agentOf("lamp-2").map(AgentStart::agent)).contains("ceiling");
    assertThat(deployment.agentOf("lamp-3")).isEmpty();
  }

  @Test
  void whatWasRemovedStaysWithoutAnAgentUntilOneIsAdded() {
    deployment.placed(AgentStart.of("lamp-1", "lights"));
    deployment.dismissed("lamp-1");
    assertThat(deployment.isDismissed("lamp-1")).isTrue();

    deployment.placed(AgentStart.of("lamp-1", "lights"));
    assertThat(deployment.isDismissed("lamp-1")).isFalse();
  }

  @Test
  void movesGoToContainersThatAreThere() {
    own("lights");
    deployment.containerThere(new ContainerStart("attic", Set.of(), Set.of(), false));
    deployment.placed(AgentStart.of("lamp-1", "lights"));

    assertThatCode(() -> deployment.requireWay("lamp-1", "attic")).doesNotThrowAnyException();
    assertThatThrownBy(() -> deployment.requireWay("lamp-1", "lights"))
        .hasMessage("The agent lamp-1 is in the container lights already.");
    assertThatThrownBy(() -> deployment.requireWay("lamp-1", "cellar"))
        .hasMessageContaining("There is no container cellar; there are attic, lights.");
    assertThatThrownBy(() -> deployment.requireWay("lamp-2", "attic"))
        .hasMessageContaining("There is no agent lamp-2 to speak of; there are lamp-1.");

    deployment.moved("lamp-1", "attic");
    assertThat(deployment.agentsIn("attic"))
        .extracting(AgentStart::agent)
        .containsExactly("lamp-1");
    assertThat(deployment.agentsIn("lights")).isEmpty();
  }

  @Test
  void namesAreSlugs() {
    assertThatThrownBy(() -> Deployment.requireContainerName("My Kitchen"))
        .hasMessage(
            "\"My Kitchen\" is no name for a container; use small letters, digits and hyphens.");
    assertThatThrownBy(() -> deployment.requireNew(AgentStart.of("Lamp", "lights")))
        .hasMessage("\"Lamp\" is no name for an agent; use small letters, digits and hyphens.");
  }

  private void own(String topic) {
    deployment.containerThere(new ContainerStart(topic, Set.of(topic), Set.of(), true));
  }
}
