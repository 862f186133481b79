package org.maestro.platform;

import java.util.Collection;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;

/**
 * Passes each sentence on to all who listen. The central agent tells, and others that have goals of
 * their own: whoever listens is told by one at a time.
 */
final class StoriesTold implements Story {
  private final Collection<Story> listeners = new ConcurrentLinkedQueue<>();

  void addListener(Story listener) {
    listeners.add(listener);
  }

  @Override
  public synchronized void tell(StoryEntry entry) {
    listeners.forEach(listener -> listener.tell(entry));
  }
}
