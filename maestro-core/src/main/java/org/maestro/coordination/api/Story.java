package org.maestro.coordination.api;

/** A sink for the entries of stories. Called on the coordinator's thread; must not block. */
public interface Story {
  void tell(StoryEntry entry);
}
