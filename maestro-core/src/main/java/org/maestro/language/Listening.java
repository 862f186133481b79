package org.maestro.language;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.hearing.Heard;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.meaning.Doubt;
import org.maestro.language.meaning.Interpreter;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.QuestionsBack;
import org.maestro.sl.Content;

/** Listens to one utterance, word by word. Not safe for threads. */
public final class Listening {
  private final Grammar grammar;
  private final HeardWords words;
  private final Situation situation;
  private final List<Understanding.Begun> began = new ArrayList<>();

  Listening(Grammar grammar, HeardWords words, Situation situation) {
    this.grammar = grammar;
    this.words = words;
    this.situation = situation;
  }

  /** Takes the next word. */
  public void hear(String word) {
    words.take(word);
    best()
        .filter(Meaning::early)
        .flatMap(Meaning::message)
        .filter(message -> began.isEmpty() || !last().message().equals(message))
        .ifPresent(message -> began.add(new Understanding.Begun(word, message)));
  }

  private Understanding.Begun last() {
    return began.get(began.size() - 1);
  }

  /** The best meaning of what was said so far, if it is certain. */
  private Optional<Meaning> best() {
    List<Meaning> meanings = soFar();
    return meanings.stream()
        .findFirst()
        .filter(one -> one.broken() == 0 && one.doubt().isEmpty() && !isAmbiguous(meanings));
  }

  /** What was said so far may mean, if it ended here; the best first. */
  public List<Meaning> soFar() {
    return new Interpreter(situation).of(words.readings());
  }

  /** The words so far, and what became of them. */
  public List<Heard> heard() {
    return words.heard();
  }

  /** Nothing more is said. */
  public Understanding end(String utterance) {
    words.end();
    List<Meaning> meanings = soFar();
    Optional<Meaning> best = meanings.stream().findFirst();
    Optional<Doubt> doubt = best.flatMap(Meaning::doubt);
    boolean isAmbiguous = best.isPresent() && isAmbiguous(meanings);
    Optional<Content> message =
        doubt.isPresent() || isAmbiguous ? Optional.empty() : best.flatMap(Meaning::message);
    QuestionsBack questions = new QuestionsBack(situation, grammar);
    Optional<String> question =
        isAmbiguous ? Optional.of(grammar.phrase("ambiguous")) : doubt.map(questions::of);
    return new Understanding(
        utterance,
        message,
        question,
        best.isEmpty() ? Optional.of(notUnderstood()) : Optional.empty(),
        words.heard(),
        meanings,
        began,
        coverage());
  }

  /** Two readings that are as good, and mean something else: nobody knows which is meant. */
  private static boolean isAmbiguous(List<Meaning> meanings) {
    Meaning best = meanings.get(0);
    return best.message().isPresent()
        && meanings.stream()
                .filter(one -> one.broken() == best.broken() && one.penalty() == best.penalty())
                .map(Meaning::message)
                .flatMap(Optional::stream)
                .distinct()
                .count()
            > 1;
  }

  private String notUnderstood() {
    List<String> unknown =
        words.heard().stream()
            .filter(word -> word.fate() == Heard.Fate.UNKNOWN)
            .map(Heard::word)
            .toList();
    return unknown.isEmpty()
        ? grammar.phrase("not-understood")
        : grammar.phrase("unknown-word").replace("{word}", String.join(" ", unknown));
  }

  private double coverage() {
    List<Heard> all = words.heard();
    long placed =
        all.stream()
            .filter(word -> word.fate() != Heard.Fate.UNKNOWN && word.fate() != Heard.Fate.UNPLACED)
            .count();
    return all.isEmpty() ? 0 : (double) placed / all.size();
  }
}
