package org.maestro.deployment;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * The agents that there are, what they stand for and where they live, and the containers that could
 * take them (Three-layered architecture, 3.3.2; M68-M72). Says where an agent belongs and what
 * speaks against it; others carry it out and report. Any thread may use it.
 */
public final class Deployment {
  private static final Pattern SLUG = Pattern.compile("[a-z0-9][a-z0-9-]{0,62}");

  private final Provision here;
  private final Map<String, ContainerStart> containers = new TreeMap<>();
  private final Map<String, AgentStart> agents = new LinkedHashMap<>();
  private final Map<String, String> agentByMember = new HashMap<>();
  private final Set<String> dismissed = new TreeSet<>();

  /** Of a platform whose own process provides nothing in particular. */
  public Deployment() {
    this(Set.of());
  }

  /**
   * @param here what the platform's own process provides
   */
  public Deployment(Set<String> here) {
    this.here = Provision.of(here);
  }

  /**
   * The container in which such an agent is to begin: the one that is named, else the one that took
   * its topic, else the platform's own of that topic, which may have to be made.
   *
   * @param named by who starts it
   * @throws DeploymentException when its host would not provide what the agent needs
   */
  public synchronized String containerFor(Optional<String> named, String topic, Set<String> needs) {
    if (named.isPresent()) {
      requireName(named.get(), "container");
      requireProvided(named.get(), needs);
      return named.get();
    }
    String usual =
        containers.values().stream()
            .filter(container -> !container.own() && container.topics().contains(topic))
            .map(ContainerStart::name)
            .findFirst()
            .orElse(topic);
    if (fits(usual, needs)) {
      return usual;
    }
    return containers.values().stream()
        .filter(container -> fits(container.name(), needs))
        .map(ContainerStart::name)
        .findFirst()
        .orElseThrow(
            () ->
                new DeploymentException(
                    "No container provides %s; join one with ./maestro container --provides %s."
                        .formatted(String.join(" and ", needs), String.join(",", needs))));
  }

  /**
   * @throws DeploymentException when no container can have that name
   */
  public static void requireContainerName(String name) {
    requireName(name, "container");
  }

  private void requireProvided(String container, Set<String> needs) {
    Set<String> missing = provides(container).lacks(Provision.of(needs));
    if (!missing.isEmpty()) {
      throw new DeploymentException(
          "The container %s does not provide %s."
              .formatted(container, String.join(" and ", missing)));
    }
  }

  private boolean fits(String container, Set<String> needs) {
    return provides(container).lacks(Provision.of(needs)).isEmpty();
  }

  /** One that is not there yet would be made in the platform's own process. */
  private Provision provides(String container) {
    return Optional.ofNullable(containers.get(container))
        .filter(known -> !known.own())
        .map(known -> Provision.of(known.provides()))
        .orElse(here);
  }

  private static void requireName(String name, String what) {
    if (!SLUG.matcher(name).matches()) {
      throw new DeploymentException(
          "\"%s\" is no name for %s %s; use small letters, digits and hyphens."
              .formatted(name, what.startsWith("a") ? "an" : "a", what));
    }
  }

  /**
   * @throws DeploymentException when such an agent cannot be added
   */
  public synchronized void requireNew(AgentStart start) {
    requireName(start.agent(), "agent");
    if (agents.containsKey(start.agent())) {
      throw new DeploymentException(
          "There is an agent %s already, in %s; reconfigure it, or remove it first."
              .formatted(start.agent(), agents.get(start.agent()).container()));
    }
    for (String member : start.members()) {
      agentOf(member)
          .ifPresent(
              other -> {
                throw new DeploymentException(
                    "The agent %s stands for %s already; reconfigure it, or remove it first."
                        .formatted(other.agent(), member));
              });
    }
  }

  /**
   * The agent of that name.
   *
   * @throws DeploymentException when there is none
   */
  public synchronized AgentStart require(String agent) {
    AgentStart start = agents.get(agent);
    if (start == null) {
      throw new DeploymentException(
          "There is no agent %s to speak of; there are %s."
              .formatted(agent, agents.isEmpty() ? "none" : String.join(", ", agents.keySet())));
    }
    return start;
  }

  /**
   * @throws DeploymentException when the agent cannot go there
   */
  public synchronized void requireWay(String agent, String container) {
    AgentStart start = require(agent);
    if (!containers.containsKey(container)) {
      throw new DeploymentException(
          "There is no container %s; there are %s. Another process joins one with ./maestro container --main HOST:PORT --name %s."
              .formatted(container, String.join(", ", containers.keySet()), container));
    }
    if (start.container().equals(container)) {
      throw new DeploymentException(
          "The agent %s is in the container %s already.".formatted(agent, container));
    }
    requireProvided(container, start.needs());
  }

  /** The agent that stands for the member. */
  public synchronized Optional<AgentStart> agentOf(String member) {
    return Optional.ofNullable(agentByMember.get(member)).map(agents::get);
  }

  public synchronized Optional<AgentStart> find(String agent) {
    return Optional.ofNullable(agents.get(agent));
  }

  /** Whether the member's agent was removed on purpose, and has not been added again. */
  public synchronized boolean isDismissed(String member) {
    return dismissed.contains(member);
  }

  /** The agent has been started, or configured or placed otherwise. */
  public synchronized void placed(AgentStart start) {
    Optional.ofNullable(agents.put(start.agent(), start)).ifPresent(this::forgetMembers);
    start.members().forEach(dismissed::remove);
    start.members().forEach(member -> agentByMember.putIfAbsent(member, start.agent()));
  }

  /** The agent lives in another container now. */
  public synchronized void moved(String agent, String container) {
    agents.computeIfPresent(agent, (name, start) -> start.in(container));
  }

  /** The agent has ended, and nobody brings it back. */
  public synchronized Optional<AgentStart> ended(String agent) {
    Optional<AgentStart> start = Optional.ofNullable(agents.remove(agent));
    start.ifPresent(this::forgetMembers);
    return start;
  }

  private void forgetMembers(AgentStart start) {
    start.members().forEach(member -> agentByMember.remove(member, start.agent()));
  }

  /** The agent was removed on purpose: its members get no other by themselves. */
  public synchronized Optional<AgentStart> dismissed(String agent) {
    Optional<AgentStart> start = ended(agent);
    start.ifPresent(gone -> dismissed.addAll(gone.members()));
    return start;
  }

  public synchronized void containerThere(ContainerStart container) {
    containers.put(container.name(), container);
  }

  public synchronized Optional<ContainerStart> containerGone(String name) {
    return Optional.ofNullable(containers.remove(name));
  }

  /** By name. */
  public synchronized List<ContainerStart> containers() {
    return List.copyOf(containers.values());
  }

  public synchronized Optional<ContainerStart> container(String name) {
    return Optional.ofNullable(containers.get(name));
  }

  /** In the order in which they were started. */
  public synchronized List<AgentStart> agents() {
    return List.copyOf(agents.values());
  }

  public synchronized List<AgentStart> agentsIn(String container) {
    return agents.values().stream().filter(start -> start.container().equals(container)).toList();
  }

  public synchronized List<AgentStart> agentsOf(String topic) {
    return agents.values().stream().filter(start -> start.topic().equals(topic)).toList();
  }
}
