package org.maestro.console.access;

import java.util.Optional;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.knowledge.Readers;
import org.maestro.agents.runtime.Caller;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.ReadingRights;

/**
 * Those who read at the console what is known, where no agent is asked: they may read what they may
 * by the desk. Any thread.
 */
public final class Readership {
  private static final String OVER = "It is over; its story is private.";

  private final Readers readers;
  private final boolean isSecured;

  /**
   * @param isSecured whether persons have to sign in
   */
  public Readership(KnowledgeBase knowledge, boolean isSecured) {
    this.readers = new Readers(knowledge::home);
    this.isSecured = isSecured;
  }

  /** What she may read who asks. */
  public ReadingRights of(Visit visit) {
    return of(visit.person());
  }

  /** What all may read who look. */
  public ReadingRights ofAll() {
    return of(Optional.empty());
  }

  /**
   * What all may read of a goal's story who look; of what is private they are told that it is over.
   */
  public Optional<StoryEntry> toAll(StoryEntry entry) {
    if (ofAll().objection(entry.privateWords()).isEmpty()) {
      return Optional.of(entry);
    }
    return entry.kind() == StoryEntry.Kind.END
        ? Optional.of(new StoryEntry(entry.goalId(), entry.at(), entry.kind(), OVER))
        : Optional.empty();
  }

  /** Whether that is told instead of the end of a story that is private. */
  public static boolean isInstead(StoryEntry told) {
    return told.text().equals(OVER);
  }

  /** The name by which agents are asked for her; empty on an open site. */
  public Optional<String> name(Visit visit) {
    return name(visit.person());
  }

  /** The same of all who look. */
  public Optional<String> nameOfAll() {
    return name(Optional.empty());
  }

  private Optional<String> name(Optional<String> person) {
    return isSecured ? Optional.of(person.orElse(AgentNames.DESK)) : Optional.empty();
  }

  private ReadingRights of(Optional<String> person) {
    return readers.of(new Caller(AgentNames.DESK, name(person)));
  }
}
