package org.maestro.rats.member;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;

/**
 * The abstract state z that the member is in, and which features it has switched off (Three-layered
 * architecture, 3.2.1; M33, M34). While a call runs, z is the running state of the latest started
 * one, otherwise the state at rest. Clock thread only.
 */
final class MemberCondition {

  private static final int MOST_RECENT = 16;

  private final MemberProfile profile;
  private final String boot;
  private final MemberProfile.Values values;
  private final Map<String, String> disabled = new TreeMap<>();
  private List<Task> running = List.of();
  private List<Task> waiting = List.of();
  private final Deque<MemberState.Ended> recent = new ArrayDeque<>();
  private String atRest;

  MemberCondition(MemberProfile profile, String boot, MemberProfile.Values values) {
    this.profile = profile;
    this.boot = boot;
    this.values = values;
    this.atRest = profile.initialState();
  }

  String state() {
    return running.isEmpty() ? atRest : running.get(running.size() - 1).feature().runningState();
  }

  /** Whether the state may follow the one at rest. */
  private boolean mayBecome(String state) {
    return profile.rules().allows(atRest, state);
  }

  /** The last resort's state, whatever the rules of states say. */
  void forced(String state) {
    atRest = state;
  }

  /**
   * @throws IllegalArgumentException when there is no such state, or it may not follow
   */
  void rest(String state) {
    if (!profile.states().contains(state)) {
      throw new IllegalArgumentException(
          "The member "
              + profile.id()
              + " has no state '"
              + state
              + "'; its description names all");
    }
    if (!mayBecome(state)) {
      throw new IllegalArgumentException(
          "The member %s cannot go from %s to %s; its rules of states do not have it"
              .formatted(profile.id(), atRest, state));
    }
    atRest = state;
  }

  String atRest() {
    return atRest;
  }

  boolean isBusy() {
    return !running.isEmpty();
  }

  /**
   * Rests in a safe state: where it is if that is one, else in the initial state, else in the first
   * by name (Three-layered architecture, 3.2.1; M36).
   */
  void restSafely() {
    if (profile.safeStates().contains(atRest)) {
      return;
    }
    atRest =
        profile.safeStates().contains(profile.initialState())
            ? profile.initialState()
            : profile.safeStates().stream().sorted().findFirst().orElseThrow();
  }

  void tasks(List<Task> nowRunning, List<Task> nowWaiting) {
    running = List.copyOf(nowRunning);
    waiting = List.copyOf(nowWaiting);
  }

  /** What the call did is in the values that are told from now on. */
  void ended(String callId, Outcome outcome) {
    if (recent.size() == MOST_RECENT) {
      recent.removeFirst();
    }
    recent.addLast(new MemberState.Ended(callId, outcome));
  }

  void disable(String feature, String reason) {
    disabled.put(feature, reason);
  }

  void enable(String feature) {
    disabled.remove(feature);
  }

  /** Why a call of it is refused as soon as it comes. */
  Optional<String> whyDisabled(String feature) {
    return Optional.ofNullable(disabled.get(feature)).or(() -> whyNotFromHere(feature));
  }

  /** Whether it could not begin now, be it that its own routine says so. */
  boolean isDisabled(String feature) {
    return whyDisabled(feature).isPresent()
        || Optional.ofNullable(profile.features().get(feature))
            .filter(known -> !known.procedure().isPossibleNow())
            .isPresent();
  }

  private Optional<String> whyNotFromHere(String feature) {
    return Optional.ofNullable(profile.features().get(feature))
        .filter(known -> !mayBecome(known.runningState()))
        .map(known -> feature + " cannot start while the member is in the state " + atRest);
  }

  MemberState snapshot() {
    return new MemberState(
        profile.id(),
        boot,
        state(),
        List.copyOf(values.current()),
        running.stream().map(task -> task.call().id()).toList(),
        waiting.stream().map(task -> task.call().id()).toList(),
        profile.features().keySet().stream().filter(this::isDisabled).sorted().toList(),
        List.copyOf(recent));
  }
}
