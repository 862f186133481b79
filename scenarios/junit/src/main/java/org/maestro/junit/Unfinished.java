package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.agents.content.OverheardReply;
import org.maestro.assembly.LocalSite;
import org.maestro.dialogue.Utterance;

/**
 * A sentence of which not all is said yet, and what is done meanwhile. What does not hold of it
 * fails the test with what was answered. For the test's thread.
 */
public final class Unfinished {
  private final LocalSite site;
  private final Utterance words;
  private final Duration patience;
  private final OverheardReply heard;

  private Unfinished(LocalSite site, Utterance words, Duration patience, OverheardReply heard) {
    this.site = site;
    this.words = words;
    this.patience = patience;
    this.heard = heard;
  }

  static Unfinished begin(LocalSite site, Utterance words, Duration patience) {
    List<OverheardReply> heard = new CopyOnWriteArrayList<>();
    site.platform().desk().overhear(words, heard::add);
    if (!site.runUntil(() -> !heard.isEmpty(), patience)) {
      throw new StageException("Nobody has answered \"" + words.text() + "\".");
    }
    return new Unfinished(site, words, patience, heard.get(0));
  }

  /** Says more. */
  public Unfinished then(String more) {
    return instead(words.text() + " " + more);
  }

  /** What was heard is revised: all of the sentence so far is this. */
  public Unfinished instead(String whole) {
    return begin(site, said(whole), patience);
  }

  private Utterance said(String text) {
    return words.saying(text);
  }

  /** Nothing more is said. */
  public Saying ends() {
    return Saying.begin(site, words, patience);
  }

  /** These individuals are looked at, by their names in the home; none: nothing is. */
  public Unfinished looksAt(String... individuals) {
    return require(heard.looks().equals(List.of(individuals)), "look at " + List.of(individuals));
  }

  /** It is certain what is wanted, if nothing else follows. */
  public Unfinished nods() {
    return require(heard.nods(), "be nodded to");
  }

  /** It is not certain yet what is wanted. */
  public Unfinished doesNotNod() {
    return require(!heard.nods(), "be nodded to by nobody");
  }

  /** So many goals are begun already. */
  public Unfinished hasBegun(int goals) {
    return require(heard.begun().size() == goals, "have begun " + goals);
  }

  /** What was begun is being undone. */
  public Unfinished undoes(int goals) {
    return require(heard.undone().size() == goals, "undo " + goals);
  }

  /** Nothing is begun, and will be, for a reason in which these words stand. */
  public Unfinished isRefused(String reason) {
    return require(
        heard.refusal().filter(why -> why.contains(reason)).isPresent(), "be refused: " + reason);
  }

  private Unfinished require(boolean holds, String expectation) {
    if (!holds) {
      throw new AssertionError(
          "\"%s\" was to %s; what became of it: %s".formatted(words.text(), expectation, heard));
    }
    return this;
  }
}
