package org.maestro.junit;

import java.time.Duration;
import java.util.Optional;
import org.maestro.assembly.LocalSite;
import org.maestro.dialogue.Utterance;

/**
 * A person of the home who speaks, and hears what is said to her or in her room. Her conversation
 * is the one that she has by all ways. For the test's thread.
 */
public final class Speaker {
  private final LocalSite site;
  private final Duration patience;
  private final String person;
  private final Hearing hearing;
  private volatile String room = "";
  private Duration spoke;

  /**
   * Somebody who listens from now on.
   *
   * @param patience how long she waits for a sentence
   */
  Speaker(LocalSite site, String person, Duration patience) {
    this.site = site;
    this.person = person;
    this.patience = patience;
    this.spoke = site.clock().now();
    this.hearing = new Hearing(site, person, patience);
  }

  /** From now on she hears what is said. */
  Speaker listening() {
    hearing.listen(speech -> speech.to().equals(person) || speech.to().equals(room));
    return this;
  }

  /** Goes to a room of the home, by its name there. */
  public Speaker in(String otherRoom) {
    room = otherRoom;
    return this;
  }

  /** Says something, and lets time pass until it is answered. */
  public Saying says(String text) {
    spoke = site.clock().now();
    return Saying.begin(site, new Utterance(person, room, text, Optional.empty()), patience);
  }

  /** Says something after which more is to come, and lets time pass until that is answered. */
  public Unfinished begins(String text) {
    spoke = site.clock().now();
    return Unfinished.begin(site, new Utterance(person, room, text, Optional.empty()), patience);
  }

  /**
   * Lets time pass until she hears this sentence, after all that she has waited for before; fails
   * the test when she does not.
   */
  public Awaited awaits(String sentence) {
    return hearing.await(sentence, spoke);
  }

  /** Nothing was said to her, or in the room in which she is; fails the test when something was. */
  public Speaker hasHeardNothing() {
    hearing.requireNothing();
    return this;
  }
}
