package org.maestro.console.states;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.pulse.LifeSign;
import org.maestro.agents.pulse.Signs;
import org.maestro.console.api.Operation;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.Deployment;
import org.maestro.deployment.Directory;
import org.maestro.platform.AgentRow;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberStatus;

/** The states of a platform's parts, looked at anew each time. Any thread may ask. */
public final class PlatformStates {
  private static final String MAIN = "Main-Container";

  private final MaestroPlatform platform;
  private final Duration shownAfter;
  private final GoneContainers gone = new GoneContainers(InstantSource.system());

  /**
   * @param shownAfter so long after it is known it is told to who listens, at the latest
   */
  public PlatformStates(MaestroPlatform platform, Duration shownAfter) {
    this.platform = platform;
    this.shownAfter = shownAfter;
  }

  public List<Operation> operations() {
    return List.of(
        Operation.get(
            "/states",
            "states",
            "The state of each part of the platform, and why: bus, journal, containers, agents,"
                + " members, each derived from what it depends on.",
            "states",
            request -> CompletableFuture.completedFuture(document())));
  }

  /** How all stands now; to be asked for often, so that who goes in between is missed. */
  public synchronized JsonNode document() {
    return StatesDocument.of(observe(), shownAfter);
  }

  private Observed observe() {
    Signs signs = platform.signs();
    List<Observed.Container> containers = containers(signs);
    Set<String> shown =
        containers.stream().map(Observed.Container::name).collect(Collectors.toSet());
    return new Observed(
        platform.busImpediment(),
        platform.journalImpediment(),
        platform.keepsJournal(),
        signs.timing(),
        containers,
        gone.without(containers),
        agents(shown),
        signs.agents(),
        phases(),
        platform.refused(),
        platform.homeless());
  }

  /** Who only came to ask is none of its parts. */
  private List<Observed.Container> containers(Signs signs) {
    Deployment deployment = platform.deployment();
    List<Observed.Container> containers = new ArrayList<>();
    signs
        .containers()
        .forEach(
            (name, sign) -> {
              Optional<ContainerStart> start = deployment.container(name);
              if (start.isPresent() || name.equals(MAIN)) {
                containers.add(container(name, sign, start));
              }
            });
    return containers;
  }

  private Observed.Container container(String name, LifeSign sign, Optional<ContainerStart> start) {
    return new Observed.Container(
        name,
        start
            .flatMap(ContainerStart::process)
            .map(process -> "process %d on %s".formatted(process.pid(), process.machine()))
            .orElse("the platform's own process"),
        start.map(ContainerStart::own).orElse(true),
        sign.condition(),
        sign.silence(),
        platform.directory().agentsIn(name).stream().map(Directory.Entry::agent).toList());
  }

  private List<Observed.Agent> agents(Set<String> shown) {
    List<Observed.Agent> agents = new ArrayList<>();
    Directory directory = platform.directory();
    Set<String> told = new TreeSet<>();
    for (AgentRow row : platform.agents()) {
      boolean isThere = directory.find(row.agent()).isPresent();
      agents.add(new Observed.Agent(row.agent(), row.container(), row.members(), isThere));
      told.add(row.agent());
    }
    for (Directory.Entry entry : directory.agents()) {
      if (shown.contains(entry.container()) && told.add(entry.agent())) {
        agents.add(new Observed.Agent(entry.agent(), entry.container(), List.of(), true));
      }
    }
    if (told.add(AgentNames.COORDINATOR)) {
      agents.add(new Observed.Agent(AgentNames.COORDINATOR, MAIN, List.of(), false));
    }
    return agents;
  }

  private Map<String, MemberStatus.Phase> phases() {
    Map<String, MemberStatus.Phase> phases = new HashMap<>();
    for (RatsLink.Member member : platform.members()) {
      phases.put(member.id(), member.phase());
    }
    return phases;
  }
}
