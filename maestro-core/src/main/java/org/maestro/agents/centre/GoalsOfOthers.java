package org.maestro.agents.centre;

import jade.core.AID;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.maestro.agents.content.Words;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Latest;
import org.maestro.sl.Content;

/**
 * The goals that agents pursue of their own accord, as they last told of them: those that are over
 * as long as there is room, and never at the cost of those that are not. Agent thread only.
 */
final class GoalsOfOthers {
  private static final long MOST_BYTES_OF_RUNNING = 1 << 20;
  private static final long MOST_BYTES_OF_ENDED = 128 << 10;
  private static final long BYTES = 1_024;
  private static final long BYTES_OF_A_CHARACTER = 3;

  private final Latest<Told> running = new Latest<>(MOST_BYTES_OF_RUNNING, Told::bytes);
  private final Latest<Told> ended = new Latest<>(MOST_BYTES_OF_ENDED, Told::bytes);

  /** Words of one of them, by whose goal it is. */
  private record Told(AID owner, Content status, long bytes) {}

  /**
   * @param state a word of {@link GoalState}, in small letters
   * @param status all that was told
   */
  void told(AID owner, String goalId, String state, Content status) {
    long bytes = BYTES + BYTES_OF_A_CHARACTER * Words.print(status).length();
    running.remove(goalId);
    ended.remove(goalId);
    (isOver(state) ? ended : running).put(goalId, new Told(owner, status, bytes));
  }

  private static boolean isOver(String state) {
    for (GoalState known : GoalState.values()) {
      if (known.name().toLowerCase(Locale.ROOT).equals(state)) {
        return known.isFinal();
      }
    }
    return false;
  }

  /** Whose goal it is; empty when it is not known here. */
  Optional<AID> owner(String goalId) {
    return running.find(goalId).or(() -> ended.find(goalId)).map(Told::owner);
  }

  /** What was told of each last. */
  List<Content> statuses() {
    List<Content> statuses = new ArrayList<>();
    ended.values().forEach(told -> statuses.add(told.status()));
    running.values().forEach(told -> statuses.add(told.status()));
    return statuses;
  }
}
