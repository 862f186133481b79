package org.maestro.platform.guard;

import java.io.ObjectInputFilter;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Lets only such objects be deserialised as containers send each other, of exactly these classes as
 * this process has them, whatever others are called. There is one filter for all streams of a
 * process, since JADE's take anything, and one for agents that arrive. Thread-safe.
 */
public final class SerialFilter implements ObjectInputFilter {
  private static final int MOST_BYTES = 1 << 20;

  /** JADE has its own way to write all else; these are what agents are made with. */
  private static final List<String> OF_COMMANDS =
      List.of(
          "java.lang.Object",
          "java.lang.String",
          "java.lang.Boolean",
          "java.lang.Number",
          "java.lang.Byte",
          "java.lang.Short",
          "java.lang.Integer",
          "java.lang.Long",
          "java.lang.Float",
          "java.lang.Double",
          "java.lang.Character",
          "java.util.Date");

  /** A generic agent, and what it takes along when it moves. */
  private static final List<String> OF_AGENTS =
      List.of(
          "org.maestro.agents.GenericAgent",
          "org.maestro.agents.runtime.MaestroAgent",
          "org.maestro.agents.device.DirectoryEntry",
          "org.maestro.agents.calls.FormerCalls",
          "org.maestro.agents.device.Movement",
          "jade.core.Agent",
          "jade.core.Agent$1",
          "jade.core.Agent$ActiveLifeCycle",
          "jade.core.AID",
          "jade.core.ContainerID",
          "jade.core.LifeCycle",
          "jade.core.Scheduler",
          "jade.core.mobility.AgentMobilityService$TransitLifeCycle",
          "jade.lang.acl.ACLMessage",
          "jade.util.Logger",
          "jade.util.Logger$DummyLogger",
          "jade.util.leap.ArrayList",
          "jade.util.leap.LinkedList",
          "jade.util.leap.Properties",
          "java.lang.Object",
          "java.lang.String",
          "java.lang.StringBuffer",
          "java.util.Date",
          "java.util.HashSet",
          "java.util.Hashtable",
          "java.util.LinkedHashSet",
          "java.util.Map$Entry",
          "java.util.Properties",
          "java.util.TreeSet",
          "java.util.Vector");

  private final Set<Class<?>> allowed;
  private final Bounds bounds;
  private final Refusals refusals = new Refusals();

  /** The limits on what is read of one stream. */
  private record Bounds(int depth, int references, int arrayLength) {
    private boolean areExceededBy(FilterInfo info) {
      return info.depth() > depth
          || info.references() > references
          || info.arrayLength() > arrayLength
          || info.streamBytes() > MOST_BYTES;
    }
  }

  private SerialFilter(List<String> names, Bounds bounds) {
    this.allowed = names.stream().map(SerialFilter::here).collect(Collectors.toUnmodifiableSet());
    this.bounds = bounds;
  }

  private static Class<?> here(String name) {
    try {
      return Class.forName(name, false, SerialFilter.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException("Agents are made of " + name + ", which is not there", e);
    }
  }

  static SerialFilter ofCommands() {
    return new SerialFilter(OF_COMMANDS, new Bounds(6, 2_000, 10_000));
  }

  static SerialFilter ofAgents() {
    return new SerialFilter(OF_AGENTS, new Bounds(30, 10_000, MOST_BYTES));
  }

  /** Once there is a filter, also one that was named at the start of Java, it stays. */
  public static synchronized void install() {
    if (ObjectInputFilter.Config.getSerialFilter() == null) {
      ObjectInputFilter.Config.setSerialFilter(ofCommands());
    }
  }

  @Override
  public Status checkInput(FilterInfo info) {
    if (bounds.areExceededBy(info)) {
      refusals.log("What was sent to be deserialised is too large, and was refused.");
      return Status.REJECTED;
    }
    if (info.serialClass() == null) {
      return Status.UNDECIDED;
    }
    Class<?> one = element(info.serialClass());
    if (one.isPrimitive() || allowed.contains(one)) {
      return Status.ALLOWED;
    }
    refusals.log(
        "What was sent to be deserialised was refused: agents need no %s."
            .formatted(one.getName()));
    return Status.REJECTED;
  }

  private static Class<?> element(Class<?> type) {
    Class<?> element = type;
    while (element.isArray()) {
      element = element.getComponentType();
    }
    return element;
  }
}
