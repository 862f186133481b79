package org.maestro.coordination.recovery;

import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Roster;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.Step;

/**
 * The calls of coordinators before this one: which of them may be asked for again, so that they are
 * done once, and what is said of the others. The coordinator's thread only.
 */
public final class FormerCalls {
  /**
   * For so long after its answer a member knows a call again, or for the call's timeout if that is
   * longer; see {@link org.maestro.rats.link.RatsLink}.
   */
  private static final Duration MEMORY = Duration.ofMinutes(10);

  /** Asking takes time too. */
  private static final Duration MARGIN = Duration.ofSeconds(30);

  private final Ports ports;
  private final Roster roster;

  /**
   * @param ports of a world in which scripts are among the members, if plans use them
   */
  public FormerCalls(Ports ports, Roster roster) {
    this.ports = ports;
    this.roster = roster;
  }

  /** Why it must not be asked for again: the member would take it for a new one. */
  public Optional<String> obstacle(Recovery.UnfinishedCall call) {
    String member = call.begun().step().member();
    if (member.equals(Script.PLANNED_AS)) {
      return feature(call).isPresent()
          ? Optional.empty()
          : Optional.of("there is no script " + call.begun().step().feature() + " any more");
    }
    if (!roster.isPresent(member)) {
      return Optional.of(member + " has not come back");
    }
    if (call.begun().call().life().isEmpty()
        || !Objects.equals(roster.life(member), call.begun().call().life())) {
      return Optional.of(member + " was started again too");
    }
    if (feature(call).isEmpty()) {
      return Optional.of(member + " has no " + call.begun().step().feature() + " any more");
    }
    Duration age = ports.clock().now().minus(call.begunAt());
    if (!call.established() && age.plus(MARGIN).compareTo(memory(call)) > 0) {
      return Optional.of(
          "it was begun "
              + age.toMinutes()
              + " minutes ago, which "
              + member
              + " may not remember");
    }
    return Optional.empty();
  }

  private static Duration memory(Recovery.UnfinishedCall call) {
    Duration timeout = call.begun().timeout();
    return timeout.compareTo(MEMORY) > 0 ? timeout : MEMORY;
  }

  private Optional<FeatureType> feature(Recovery.UnfinishedCall call) {
    return Optional.ofNullable(ports.knowledge().home().devices().get(call.begun().step().member()))
        .stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(call.begun().step().feature()))
        .findFirst();
  }

  /** The order as it was given before; only for a call without an obstacle. */
  public ActionDispatcher.Request order(Recovery.UnfinishedCall call) {
    JournalEntry.Begun begun = call.begun();
    Step step =
        new Step(
            begun.number(),
            begun.step().member(),
            feature(call).orElseThrow(),
            begun.step().bindings(),
            begun.seconds(),
            begun.seconds(),
            true,
            Set.of());
    return new ActionDispatcher.Request(
        begun.goalId(), step, begun.parameters(), begun.timeout(), Optional.of(begun.call()));
  }

  /** Nobody will hear what becomes of it; where it still runs it is ended. */
  public void giveUp(Recovery.UnfinishedCall call, String why) {
    JournalEntry.Begun begun = call.begun();
    ports
        .journal()
        .write(new JournalEntry.Ended(begun.goalId(), begun.call().id(), Optional.of(why)));
    ports.dispatcher().callOff(begun.step().member(), begun.call());
  }
}
