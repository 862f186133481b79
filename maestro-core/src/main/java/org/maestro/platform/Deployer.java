package org.maestro.platform;

import jade.wrapper.AgentContainer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.device.Host;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.supervision.Welcome;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.Deployment;
import org.maestro.deployment.DeploymentException;
import org.maestro.platform.failover.MigrationReservations;
import org.maestro.platform.failover.TakeoverLinks;
import org.maestro.platform.jade.AgentsByName;
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeRuntime;

/**
 * Starts and ends the agents of a platform where the deployment has them: in containers of this
 * process, one for each topic (Three-layered architecture, 3.3.2; M70), or, by their configuration
 * alone, in containers that other processes have joined. Any thread may call, one at a time.
 */
final class Deployer {
  private final Deployment deployment;
  private final Surroundings here;
  private final TakeoverLinks heirs;
  private final AgentsByName jade;
  private final OwnContainers own;
  private final Map<String, String> containerByGroup = new TreeMap<>();

  /**
   * Agents that took over from one that was lost with a container, and the name under which they
   * call.
   */
  private final Map<String, String> heirOf = new ConcurrentSkipListMap<>();

  /** Agents whose container, of another process, may be back soon. */
  private final Set<String> awaited = new TreeSet<>();

  private final MigrationReservations handing = new MigrationReservations();

  /** Agents that live in other processes. */
  private final Set<String> elsewhere = new ConcurrentSkipListSet<>();

  /**
   * @param here what this process's containers give to their agents
   * @param newContainer joins a container of that name to the platform
   * @param heirs of containers that are lost
   * @param jade begins and ends agents by their names
   * @param provides what this process has for agents
   */
  Deployer(
      Surroundings here,
      BiFunction<String, Host, AgentContainer> newContainer,
      TakeoverLinks heirs,
      AgentsByName jade,
      Set<String> provides) {
    this.deployment = new Deployment(provides);
    this.here = here;
    this.own =
        new OwnContainers(deployment, provides, name -> newContainer.apply(name, new Host(here)));
    this.heirs = heirs;
    this.jade = jade;
  }

  Deployment deployment() {
    return deployment;
  }

  /** Agents that other processes have asked for. */
  MigrationReservations handing() {
    return handing;
  }

  /** Starts the agent unless its members have one, or were dismissed. */
  synchronized boolean place(AgentStart start) {
    if (!isNew(start)) {
      return false;
    }
    begin(start.in(deployment.containerFor(Optional.empty(), start.topic(), start.needs())));
    return true;
  }

  private boolean isNew(AgentStart start) {
    return deployment.find(start.agent()).isEmpty()
        && start.members().stream()
            .noneMatch(m -> deployment.agentOf(m).isPresent() || deployment.isDismissed(m));
  }

  /**
   * The agent lived in a container that joins again, as far as one can know: it is noted down, and
   * begins there when that has happened, or where {@link #reclaim} has it begin.
   *
   * @return false when its members have an agent, or were dismissed, or it could begin at once
   */
  synchronized boolean await(AgentStart start, String container) {
    if (!isNew(start)) {
      return false;
    }
    if (isElsewhere(container)) {
      begin(start.in(container));
      return false;
    }
    deployment.placed(start.in(container));
    awaited.add(start.agent());
    return true;
  }

  /**
   * Starts all of them, or none.
   *
   * @throws DeploymentException when one cannot be started
   */
  synchronized void add(List<AgentStart> starts) {
    starts.forEach(deployment::requireNew);
    starts.forEach(this::begin);
  }

  synchronized void placeGroup(String group, String topic, MaestroAgent agent) {
    JadeRuntime.start(own.of(topic), group, agent);
    containerByGroup.put(group, topic);
  }

  synchronized void removeGroup(String group) {
    containerByGroup.remove(group);
    jade.kill(group);
  }

  /** It is noted down first: from its first word on it is to be known whom it stands for. */
  private void begin(AgentStart start) {
    Optional<AgentStart> before = deployment.find(start.agent());
    deployment.placed(start);
    try {
      create(start);
    } catch (RuntimeException e) {
      before.ifPresentOrElse(deployment::placed, () -> deployment.ended(start.agent()));
      throw e;
    }
  }

  private void create(AgentStart start) {
    if (isElsewhere(start.container())) {
      elsewhere.add(start.agent());
      heirOf.remove(start.agent());
      jade.create(start);
    } else {
      elsewhere.remove(start.agent());
      AgentContainer container = own.of(start.container());
      JadeRuntime.start(
          container,
          start.agent(),
          new GenericAgent(Birth.of(container), surroundings(start.agent()), start));
    }
  }

  private Surroundings surroundings(String agent) {
    return Optional.ofNullable(heirOf.get(agent))
        .filter(controller -> !controller.equals(here.link().controller()))
        .flatMap(heirs::of)
        .map(here::with)
        .orElse(here);
  }

  /** Whether the agent that ended, as JADE tells once for each, was to begin again elsewhere. */
  boolean wasHandedOver(String agent) {
    return jade.wasHandedOver(agent);
  }

  boolean isElsewhere(String container) {
    return deployment.container(container).filter(known -> !known.own()).isPresent();
  }

  /**
   * Makes room for a container that joins: one of this process that has its name ends, and its
   * agents begin again there. JADE may take some seconds for that.
   *
   * @param asker the agent that asks for it; its agents are given back when it is no more
   * @param leaving is told of each agent that ends here
   */
  void admit(ContainerStart joining, String asker, Consumer<String> leaving) {
    Optional<AgentContainer> ended = release(joining.name(), asker, leaving);
    try {
      makeRoom(joining, ended);
    } finally {
      handing.admitted(joining.name());
    }
  }

  private void makeRoom(ContainerStart joining, Optional<AgentContainer> ended) {
    ended.ifPresent(ContainerEnds::endNow);
    jade.awaitEnds(handing.awaiting(joining.name()));
    if (!jade.awaitEnd(joining.name())) {
      ended
          .filter(AgentContainer::isJoined)
          // Whoever joins next tries to end it once more.
          .ifPresent(container -> own.keep(joining.name(), container));
      throw new DeploymentException(
          "The platform still has a container %s, which does not end; the platform's log says why. Join again in a moment, or choose another --name."
              .formatted(joining.name()));
    }
    // Not before: an agent that still lived would report what it has under way as failed.
    heirs.letGo(TakeoverLinks.controller(joining.name()));
  }

  private synchronized Optional<AgentContainer> release(
      String name, String asker, Consumer<String> leaving) {
    Deployment.requireContainerName(name);
    if (isElsewhere(name)) {
      throw new DeploymentException(
          "The platform has a container %s already; choose another --name.".formatted(name));
    }
    List<String> groups =
        containerByGroup.entrySet().stream()
            .filter(group -> group.getValue().equals(name))
            .map(Map.Entry::getKey)
            .toList();
    if (!groups.isEmpty()) {
      throw new DeploymentException(
          "The container %s stays where the collective knowledge is, which its agents that stand for groups pursue goals with: %s; take another, or give them a container of their own in the home file (maestro:container)."
              .formatted(name, String.join(", ", groups)));
    }
    List<AgentStart> starts =
        deployment.agents().stream()
            .filter(
                start ->
                    start.container().equals(name)
                        || TakeoverLinks.controller(name).equals(heirOf.get(start.agent())))
            .toList();
    handing.begin(name, asker, starts, this::controllerOf);
    for (AgentStart start : starts) {
      if (!awaited.remove(start.agent())) {
        jade.endsHere(start.agent());
        jade.kill(start.agent());
      }
      leaving.accept(start.agent());
    }
    deployment.containerGone(name);
    return own.release(name);
  }

  /** Under whose name it has called, or the one that was there before it. */
  private String controllerOf(AgentStart start) {
    if (awaited.contains(start.agent())) {
      return TakeoverLinks.controller(start.container());
    }
    return heirOf.getOrDefault(start.agent(), here.link().controller());
  }

  /**
   * Who asked for a container is no more. Waits for JADE.
   *
   * @return agents that have no place for it, and under whose names they have called
   */
  Map<String, String> givenUp(String asker) {
    Map<String, String> back = handing.givenUp(asker);
    elsewhere.removeAll(back.keySet());
    return back;
  }

  /** A container has joined; returns the agents that it is to begin and those that are to move. */
  synchronized Welcome welcome(ContainerStart joined) {
    List<AgentStart> starts = handing.joined(joined.name());
    Set<String> topics = new TreeSet<>(joined.topics());
    if (starts.stream().anyMatch(start -> start.topic().equals(joined.name()))) {
      topics.add(joined.name());
    }
    deployment.containerThere(joined.with(topics));
    List<AgentStart> begun = starts.stream().map(start -> start.in(joined.name())).toList();
    for (AgentStart start : begun) {
      elsewhere.add(start.agent());
      heirOf.remove(start.agent());
      deployment.placed(start);
    }
    List<String> toMove = new ArrayList<>();
    for (AgentStart start : deployment.agents()) {
      if (topics.contains(start.topic())
          && !start.container().equals(joined.name())
          && !awaited.contains(start.agent())) {
        toMove.add(start.agent());
      }
    }
    return new Welcome(begun, toMove);
  }

  /** Ends the agent for good. */
  synchronized AgentStart remove(String agent) {
    AgentStart start = deployment.require(agent);
    elsewhere.remove(agent);
    deployment.dismissed(agent);
    jade.kill(agent);
    return start;
  }

  /**
   * An agent has ended that was not handed over. One of this process stays noted down: JADE tells
   * the same when another process, which was frozen and given up, ends its agent of that name.
   *
   * @return how it was started, if it was lost with another process and is to begin again here
   */
  Optional<AgentStart> ended(String agent) {
    return elsewhere.remove(agent) ? deployment.find(agent) : Optional.empty();
  }

  /** The agent lives in another container now. */
  void moved(String agent, String container) {
    if (isElsewhere(container)) {
      elsewhere.add(agent);
    } else {
      elsewhere.remove(agent);
    }
    heirOf.remove(agent);
    deployment.moved(agent, container);
  }

  /**
   * The process that had the agent has lost it: it comes back to a container of its topic.
   *
   * @param controller under whose name it goes on
   */
  synchronized void reclaim(String agent, String controller) {
    Optional<AgentStart> lost = deployment.find(agent);
    boolean wasAwaited = awaited.remove(agent);
    if (lost.isEmpty() || hasPlace(agent)) {
      return;
    }
    if (wasAwaited && isElsewhere(lost.get().container())) {
      begin(lost.get());
      return;
    }
    if (isElsewhere(lost.get().container())) {
      deployment.containerGone(lost.get().container());
    }
    deployment.ended(agent);
    heirOf.put(agent, controller);
    try {
      begin(
          lost.get()
              .in(
                  deployment.containerFor(
                      Optional.empty(), lost.get().topic(), lost.get().needs())));
    } catch (RuntimeException e) {
      // How it was started is needed the next time.
      deployment.placed(lost.get());
      throw e;
    }
  }

  /** Whether another process has it, or is about to. */
  private boolean hasPlace(String agent) {
    return elsewhere.contains(agent) || handing.isAwaiting(agent);
  }

  /**
   * The agent is to begin in another process, under the name under which the one before it called.
   */
  synchronized void rescued(String agent, String container, String controller) {
    awaited.remove(agent);
    moved(agent, container);
    heirOf.put(agent, controller);
  }

  /**
   * Another takes the place of an agent that hangs, in the same container. Waits for JADE.
   *
   * @param end takes it out of its container
   */
  synchronized void replace(String agent, Consumer<String> end) {
    AgentStart start = deployment.require(agent);
    jade.endsHere(agent);
    end.accept(start.container());
    jade.awaitEnds(List.of(start));
    begin(start);
  }

  /** Under which names of other containers agents call, by agent. */
  Map<String, String> borrowedNames() {
    return Map.copyOf(heirOf);
  }

  /**
   * The agent begins again in its container, and calls under that container's own name. Waits for
   * JADE.
   */
  synchronized void giveBack(String agent) {
    String controller = heirOf.remove(agent);
    replace(agent, container -> jade.kill(agent));
    if (controller != null && !heirOf.containsValue(controller)) {
      heirs.letGo(controller);
    }
  }

  /** An agent that was started by other means. */
  synchronized void startedByHand(AgentStart start) {
    deployment.requireNew(start);
    deployment.placed(start);
    moved(start.agent(), start.container());
  }

  AgentStart requireMovable(String agent, String container) {
    Optional<String> group = Optional.ofNullable(containers().get(agent));
    if (group.isPresent() && deployment.find(agent).isEmpty()) {
      throw new DeploymentException(
          "The agent %s stands for a group and stays where the collective knowledge is."
              .formatted(agent));
    }
    deployment.requireWay(agent, container);
    return deployment.require(agent);
  }

  /** Topics whose containers are of this process. */
  List<String> topics() {
    return own.topics();
  }

  /** Container by agent, in the order in which they were started; groups last. */
  synchronized Map<String, String> containers() {
    Map<String, String> containers = new LinkedHashMap<>();
    deployment.agents().forEach(start -> containers.put(start.agent(), start.container()));
    containers.putAll(containerByGroup);
    return containers;
  }

  /** No agent is started any more; returns what is to be ended of this process. */
  synchronized List<AgentContainer> close() {
    return own.releaseAll();
  }
}
