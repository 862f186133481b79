package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.assembly.LocalSite;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Utterance;

/**
 * A person of the home who speaks, and hears what is said to her or in her room. Her conversation
 * is the one that she has by all ways. For the test's thread.
 */
public final class Speaker {
  private final LocalSite site;
  private final Duration patience;
  private final String person;
  private final List<Sentence> heard = new CopyOnWriteArrayList<>();
  private volatile String room = "";
  private Duration spoke;
  private int awaited;

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
  }

  /** What she heard, and when. */
  record Sentence(String text, Duration at) {}

  /** From now on she hears what is said. */
  Speaker listening() {
    site.platform().desk().whenSaid(this::hear);
    return this;
  }

  private void hear(Speech speech) {
    if (speech.to().equals(person) || speech.to().equals(room)) {
      heard.add(new Sentence(speech.text(), site.clock().now()));
    }
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
    if (!site.runUntil(() -> find(sentence).isPresent(), patience)) {
      throw new StageException(
          "%s has not heard \"%s\" within %s; heard was: %s"
              .formatted(person, sentence, patience, heard.stream().map(Sentence::text).toList()));
    }
    Sentence found = find(sentence).orElseThrow();
    awaited = heard.indexOf(found) + 1;
    return new Awaited(found.text(), found.at().minus(spoke));
  }

  /** Nothing was said to her, or in the room in which she is; fails the test when something was. */
  public Speaker hasHeardNothing() {
    if (!heard.isEmpty()) {
      throw new AssertionError(
          "%s was to hear nothing; heard was: %s"
              .formatted(person, heard.stream().map(Sentence::text).toList()));
    }
    return this;
  }

  private Optional<Sentence> find(String sentence) {
    return heard.stream().skip(awaited).filter(one -> one.text().equals(sentence)).findFirst();
  }
}
