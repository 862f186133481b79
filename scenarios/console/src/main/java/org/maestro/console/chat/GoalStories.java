package org.maestro.console.chat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The stories of goals that were stated in conversations. A story begins before who stated the goal
 * knows its id, so that the latest sentences of all are kept for a while. Any thread may use it.
 */
public final class GoalStories implements Story {
  private static final int RECENT = 500;
  private static final int MOST_FOLLOWED = 200;

  private final Deque<StoryEntry> recent = new ArrayDeque<>();
  private final Map<String, Consumer<StoryEntry>> followers = BoundedMap.ofNewest(MOST_FOLLOWED);

  @Override
  public synchronized void tell(StoryEntry entry) {
    recent.addLast(entry);
    if (recent.size() > RECENT) {
      recent.removeFirst();
    }
    Consumer<StoryEntry> follower = followers.get(entry.goalId());
    if (follower != null) {
      follower.accept(entry);
      forget(entry);
    }
  }

  private void forget(StoryEntry entry) {
    if (entry.kind() == StoryEntry.Kind.END) {
      followers.remove(entry.goalId());
    }
  }

  /** Tells the listener a goal's story, from its beginning as far as that is kept, to its end. */
  synchronized void follow(String goal, Consumer<StoryEntry> listener) {
    followers.put(goal, listener);
    for (StoryEntry entry : recent) {
      if (entry.goalId().equals(goal)) {
        listener.accept(entry);
        forget(entry);
      }
    }
  }
}
