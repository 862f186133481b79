package org.maestro.platform.failover;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;

/**
 * Under which names members were called for what was under way when the process before this one
 * ended: the agents of some lived in other processes. A member takes the same words under another
 * name for a new call.
 */
public final class FormerCallers {
  private final Map<String, String> controllerByMember;

  private FormerCallers(Map<String, String> controllerByMember) {
    this.controllerByMember = Collections.unmodifiableMap(controllerByMember);
  }

  /**
   * @param own the name under which this process calls
   */
  public static FormerCallers of(Recovery recovery, String own) {
    Map<String, String> controllerByMember = new TreeMap<>();
    Stream.concat(
            recovery.goals().stream().flatMap(goal -> goal.calls().stream()),
            recovery.unwanted().stream())
        .map(Recovery.UnfinishedCall::begun)
        .forEach(
            begun ->
                controller(begun)
                    .filter(name -> !name.equals(own))
                    .ifPresent(name -> controllerByMember.put(begun.step().member(), name)));
    return new FormerCallers(controllerByMember);
  }

  /** A life is the member's boot and, behind an at sign, who calls it. */
  private static Optional<String> controller(JournalEntry.Begun begun) {
    return begun
        .call()
        .life()
        .filter(life -> life.contains("@"))
        .map(life -> life.substring(life.lastIndexOf('@') + 1));
  }

  /** Empty when nothing was under way with it, or it was called under this process's name. */
  public Optional<String> of(String member) {
    return Optional.ofNullable(controllerByMember.get(member));
  }
}
