package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.maestro.assembly.LocalSite;
import org.maestro.coordination.api.Speech;

/** What somebody, or all in a room, have heard since they began to listen. */
final class Hearing {
  private final LocalSite site;
  private final String who;
  private final Duration patience;
  private final List<Sentence> heard = new CopyOnWriteArrayList<>();
  private int awaited;

  /**
   * @param who is told when nothing was heard
   * @param patience how long a sentence is waited for
   */
  Hearing(LocalSite site, String who, Duration patience) {
    this.site = site;
    this.who = who;
    this.patience = patience;
  }

  /** A sentence, and when it was said. */
  private record Sentence(String text, Duration at) {}

  /**
   * From now on it hears what is said.
   *
   * @param reaches whether it is near enough to hear that
   */
  void listen(Predicate<Speech> reaches) {
    site.platform()
        .desk()
        .whenSaid(
            speech -> {
              if (reaches.test(speech)) {
                heard.add(new Sentence(speech.text(), site.clock().now()));
              }
            });
  }

  /** Lets time pass until the sentence is heard, after all that was waited for before. */
  Awaited await(String sentence, Duration since) {
    if (!site.runUntil(() -> find(sentence).isPresent(), patience)) {
      throw new StageException(
          "%s has not heard \"%s\" within %s; heard was: %s"
              .formatted(who, sentence, patience, texts()));
    }
    Sentence found = find(sentence).orElseThrow();
    awaited = heard.indexOf(found) + 1;
    return new Awaited(found.text(), found.at().minus(since));
  }

  private Optional<Sentence> find(String sentence) {
    return heard.stream().skip(awaited).filter(one -> one.text().equals(sentence)).findFirst();
  }

  void requireNothing() {
    if (!heard.isEmpty()) {
      throw new AssertionError("%s was to hear nothing; heard was: %s".formatted(who, texts()));
    }
  }

  private List<String> texts() {
    return heard.stream().map(Sentence::text).toList();
  }
}
