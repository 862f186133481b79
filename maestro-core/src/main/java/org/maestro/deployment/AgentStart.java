package org.maestro.deployment;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The start of an agent, how and where: all that is needed to start it again, here or elsewhere.
 *
 * @param agent its local name
 * @param charges the members it stands for, at least one (Three-layered architecture, 3.3.2; M71)
 * @param topic what it is about, such as {@code lights}: decides its container when nobody names
 *     one
 * @param needs what its host has to provide, such as {@code microphone}
 * @param container in which it lives
 */
public record AgentStart(
    String agent, List<Charge> charges, String topic, Set<String> needs, String container) {
  public AgentStart {
    charges = List.copyOf(charges);
    needs = Collections.unmodifiableSet(new TreeSet<>(needs));
  }

  /** Of an agent for one member of its own name, which describes itself. */
  public static AgentStart of(String member, String topic) {
    return new AgentStart(
        member, List.of(new Charge(member, Optional.empty())), topic, Set.of(), topic);
  }

  public AgentStart in(String otherContainer) {
    return new AgentStart(agent, charges, topic, needs, otherContainer);
  }

  /** The same agent, otherwise configured. */
  public AgentStart with(List<Charge> otherCharges) {
    return new AgentStart(agent, otherCharges, topic, needs, container);
  }

  public List<String> members() {
    return charges.stream().map(Charge::member).toList();
  }

  public boolean standsFor(String member) {
    return members().contains(member);
  }
}
