package org.maestro.agents.knowledge;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.maestro.agents.content.Words;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.calibration.CalibratedKnowledge;
import org.maestro.sl.Content;

/**
 * A copy of the collective knowledge, in a process of parts that think where it is not itself (ADE,
 * 3; A15). What the knowledge agent tells is known here a message later; what a part here learns is
 * known here at once, and told the knowledge agent. The past is known since the copy began; devices
 * are those of the home's file. Ages count from when something was told last. Any thread may ask.
 */
public final class KnowledgeCopy extends ForwardingKnowledge {
  private final List<Consumer<Content>> tellers = new CopyOnWriteArrayList<>();
  private final Map<String, String> sinceByFact = new HashMap<>();
  private volatile boolean begun;

  /**
   * @param own what is known here, of the same home; closed by who opened it
   */
  public KnowledgeCopy(KnowledgeBase own) {
    super(own);
  }

  /** Has what is learnt here told to the knowledge agent. */
  void whenLearnt(Consumer<Content> teller) {
    tellers.add(teller);
  }

  /** Whether the knowledge agent has told anything yet. */
  public boolean hasBegun() {
    return begun;
  }

  /** Takes over what the knowledge agent tells in one message. */
  synchronized void heard(List<Content> contents) {
    Map<Source, List<String>> byDevice = new LinkedHashMap<>();
    for (Content content : contents) {
      Words words = Words.of(content);
      words.string("unknown").ifPresent(this::forget);
      words.string("fact").ifPresent(fact -> heard(fact, words, byDevice));
    }
    byDevice.forEach(super::state);
    begun = true;
  }

  /** What a device says of itself is taken over as it says it, all of it at once. */
  private void heard(String fact, Words words, Map<Source, List<String>> byDevice) {
    Source source = source(words);
    boolean isNew = !words.string("since").equals(Optional.ofNullable(sinceByFact.get(fact)));
    words.string("since").ifPresent(since -> sinceByFact.put(fact, since));
    if (source.kind() == Source.Kind.STATED) {
      byDevice.computeIfAbsent(source, one -> new ArrayList<>()).add(fact);
    } else if (isNew) {
      super.state(source, List.of(fact));
    }
  }

  private void forget(String unknown) {
    super.state(new Source(Source.Kind.OBSERVED, "memory"), List.of(unknown));
  }

  /** Here it does not count any more; what the knowledge agent learns anew is told again. */
  @Override
  public boolean doubt(List<String> conditions) {
    List<String> shares = CalibratedKnowledge.doubtful(home(), snapshot(), conditions);
    shares.forEach(this::forget);
    return !shares.isEmpty();
  }

  private static Source source(Words words) {
    return new Source(
        Source.Kind.valueOf(words.string("kind").orElse("observed").toUpperCase(Locale.ROOT)),
        words.string("source").orElse("memory"));
  }

  @Override
  public Change learn(FeatureRun run) {
    Change change = super.learn(run);
    if (run.succeeded()) {
      tell(
          Words.content(
              "inform",
              Words.named("member", Words.name(run.member())),
              Words.named("feature", Words.name(run.feature().name())),
              Words.terms("bindings", run.bindings()),
              Words.terms("outputs", run.outputs())));
    }
    return change;
  }

  @Override
  public void state(Source source, List<String> facts) {
    super.state(source, facts);
    tell(
        Words.content(
            "inform",
            Words.named("source", Words.text(source.agent())),
            Words.named("facts", facts.stream().map(Words::text).toList())));
  }

  private void tell(Content content) {
    tellers.forEach(teller -> teller.accept(content));
  }
}
