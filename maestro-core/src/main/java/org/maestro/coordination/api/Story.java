package org.maestro.coordination.api;

/** Where stories are told. Called on the coordinator's thread; must not block. */
public interface Story {
  void tell(StoryEntry entry);
}
