package org.maestro.bench.words;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.language.Language;
import org.maestro.language.Listening;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Situation;
import org.maestro.sl.Content;
import org.maestro.sl.SlPrinter;

/**
 * How early and how steadily it is known what is meant while words are heard (Schlangen, Baumann
 * and Atterer, 2009). What is supposed after a word is the message of the best reading, where it is
 * certain, else what was supposed before; its increments are the names and predicates in it. Not
 * safe for threads.
 */
final class Increments {
  private int edits;
  private int needed;
  private final List<Double> firstCorrect = new ArrayList<>();
  private final List<Double> firstFinal = new ArrayList<>();

  /** Listens to an utterance; one without a message at the end says nothing of this. */
  void hear(Language language, List<String> words, Situation situation) {
    Listening listening = language.listen(situation);
    List<Set<String>> supposed = new ArrayList<>();
    Optional<Content> latest = Optional.empty();
    for (String word : words) {
      listening.hear(word);
      Optional<Content> now = best(listening.soFar());
      latest = now.isPresent() ? now : latest;
      supposed.add(parts(latest));
    }
    Set<String> meant = parts(listening.end(String.join(" ", words)).message());
    if (meant.isEmpty()) {
      return;
    }
    for (String part : meant) {
      firstCorrect.add((double) first(supposed, part) / words.size());
      firstFinal.add((double) settled(supposed, part) / words.size());
    }
    count(supposed, meant);
  }

  /** The message of the best reading, where it is certain. */
  private static Optional<Content> best(List<Meaning> meanings) {
    List<Meaning> tied =
        meanings.stream()
            .filter(
                one ->
                    one.broken() == meanings.get(0).broken()
                        && one.penalty() == meanings.get(0).penalty())
            .toList();
    boolean isOne = tied.stream().map(Meaning::message).distinct().count() == 1;
    return isOne && tied.get(0).broken() == 0 && tied.get(0).doubt().isEmpty()
        ? tied.get(0).message()
        : Optional.empty();
  }

  private static Set<String> parts(Optional<Content> message) {
    Set<String> parts = new LinkedHashSet<>();
    message
        .map(SlPrinter::print)
        .ifPresent(text -> parts.addAll(List.of(text.replaceAll("[()]", " ").strip().split(" +"))));
    return parts;
  }

  /** After how many words the part is there first; all of them when it is there at the end only. */
  private static int first(List<Set<String>> supposed, String part) {
    for (int i = 0; i < supposed.size(); i++) {
      if (supposed.get(i).contains(part)) {
        return i + 1;
      }
    }
    return supposed.size();
  }

  /** After how many words it is there and stays. */
  private static int settled(List<Set<String>> supposed, String part) {
    int after = supposed.size();
    while (after > 1 && supposed.get(after - 2).contains(part)) {
      after--;
    }
    return after;
  }

  /** Each part that is taken up and each that is taken back is an edit; one a part is needed. */
  private void count(List<Set<String>> supposed, Set<String> meant) {
    List<Set<String>> all = new ArrayList<>(supposed);
    all.add(meant);
    Set<String> before = Set.of();
    for (Set<String> now : all) {
      Set<String> changed = new HashSet<>(before);
      changed.addAll(now);
      Set<String> kept = new HashSet<>(before);
      kept.retainAll(now);
      edits += changed.size() - kept.size();
      before = now;
    }
    needed += meant.size();
  }

  /** The mean share of the words after which a part was there first; empty without any. */
  OptionalDouble firstCorrect() {
    return firstCorrect.stream().mapToDouble(share -> share).average();
  }

  /** The mean share of the words after which it was there and stayed. */
  OptionalDouble firstFinal() {
    return firstFinal.stream().mapToDouble(share -> share).average();
  }

  /** The share of edits that would not have been needed. */
  OptionalDouble editOverhead() {
    return edits == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of((double) (edits - needed) / edits);
  }
}
