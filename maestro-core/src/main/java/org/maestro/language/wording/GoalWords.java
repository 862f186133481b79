package org.maestro.language.wording;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Formula;

/** What becomes of wishes, and what is answered about them. Immutable. */
public final class GoalWords {
  private static final int MOST = 5;
  private static final double CENTI = 100;

  private final Optional<String> listener;
  private final Phrases phrases;
  private final SpanWords spans;
  private final Naming naming;
  private final FactWords facts;
  private final DeedWords deeds;
  private final ReportWords reports;
  private final StepWords steps;

  /**
   * In a language.
   *
   * @param listener the person who is spoken to, by her name in the home
   */
  public GoalWords(Home home, Grammar grammar, Optional<String> listener) {
    this.listener = listener;
    this.phrases = new Phrases(grammar);
    this.spans = new SpanWords(grammar);
    this.naming = new Naming(home, grammar);
    this.facts = new FactWords(home, grammar, listener);
    this.deeds = new DeedWords(home, grammar, listener);
    this.reports = new ReportWords(home, grammar, listener);
    this.steps = new StepWords(home, grammar, listener);
  }

  /** That it is taken on. */
  public String accepted(Wish wish) {
    return deed(wish).map(deed -> with("will", "deed", deed)).orElseGet(() -> phrases.of("no"));
  }

  /**
   * That it is so now.
   *
   * @param goal with what was found for its variables; empty when it is no formula
   * @param seen whether somebody has seen it who did not do it
   */
  public String reached(Optional<Formula> goal, boolean seen) {
    String fact = goal.flatMap(facts::sentence).orElseGet(() -> phrases.of("reached"));
    return seen ? fact : fact + " " + phrases.of("not-seen");
  }

  /** That it is not so, and why. */
  public String failed(Wish wish, List<String> reasons) {
    String failed =
        deed(wish)
            .map(deed -> with("could-not", "deed", deed))
            .orElseGet(() -> phrases.of("failed"));
    return Stream.concat(Stream.of(failed), reasons.stream().map(this::report))
        .collect(Collectors.joining(" "));
  }

  /** That nothing more is done for it. */
  public String calledOff(Wish wish) {
    return doing(wish)
        .map(doing -> with("no-longer", "doing", doing))
        .orElseGet(() -> phrases.of("called-off"));
  }

  /** A report of an agent, or of a goal's story. */
  public String report(String text) {
    return Phrases.sentence(reports.of(text));
  }

  /**
   * A step of a plan that has begun.
   *
   * @param member who does it
   * @param feature of the member, by its name
   * @param told the feature's sentence, with ids in its places
   */
  public String step(String member, String feature, String told) {
    return steps.of(member, feature, told);
  }

  /** A phrase that says it all. */
  public String phrase(String name) {
    return phrases.of(name);
  }

  /** What is being done. */
  public String doing(List<Wish> wishes) {
    return told(wishes.stream().map(this::doing).toList(), "doing", "doing", "doing-nothing");
  }

  /** What is to be done later. */
  public String planned(List<Wish> wishes) {
    return told(wishes.stream().map(this::deed).toList(), "will", "deed", "planned-nothing");
  }

  /** What was done. */
  public String done(List<Wish> wishes) {
    return told(wishes.stream().map(this::deed).toList(), "was-done", "deed", "done-nothing");
  }

  private String told(List<Optional<String>> words, String phrase, String place, String none) {
    List<String> all = words.stream().flatMap(Optional::stream).distinct().limit(MOST).toList();
    return all.isEmpty() ? phrases.of(none) : with(phrase, place, phrases.listed(all));
  }

  /** What was asked for, each with how long ago. */
  public String asked(List<Wish> wishes) {
    String told =
        wishes.stream().limit(MOST).map(this::reason).distinct().collect(Collectors.joining(" "));
    return told.isEmpty() ? phrases.of("asked-nothing") : told;
  }

  /** That it is done as somebody asked for it. */
  public String reason(Wish wish) {
    return phrases.of(
        wish.by().isEmpty() ? "asked" : isListener(wish) ? "asked-by-you" : "asked-by",
        Map.of("who", who(wish), "deed", named(wish), "ago", spans.ago(wish.ago())));
  }

  /** Who did it. */
  public String doer(Wish wish) {
    return wish.by().isEmpty()
        ? reason(wish)
        : Phrases.capitalized(
            phrases.of("did", Map.of("who", who(wish), "ago", spans.ago(wish.ago()))));
  }

  private boolean isListener(Wish wish) {
    return wish.by().isPresent() && wish.by().equals(listener);
  }

  private String who(Wish wish) {
    return isListener(wish) ? phrases.of("you") : wish.by().map(naming::word).orElse("");
  }

  /** For how long it has been so. */
  public String since(Duration span) {
    return with("so-since", "span", spans.of(span));
  }

  /** When it will be so, where people have words for that. */
  public Optional<String> foretold(Optional<Formula> goal, Duration rest) {
    return goal.flatMap(formula -> facts.foretold(formula, spans.of(rest)));
  }

  /**
   * That somebody else answers.
   *
   * @param seconds that asking has taken
   */
  public String passedOn(String who, double seconds) {
    return phrases.of(
        "passed-on",
        Map.of("who", who, "seconds", phrases.number(Math.round(seconds * CENTI) / CENTI)));
  }

  /** How long it takes from now on. */
  public String lasts(Duration rest) {
    return with("lasts", "span", spans.of(rest));
  }

  /** That other things are done before. */
  public String waitsFor(List<Wish> others) {
    return told(others.stream().map(this::doing).toList(), "waits-for", "doing", "waits");
  }

  /** Which of these is meant. */
  public String which(List<Wish> wishes) {
    List<String> choices = choices(wishes);
    int last = choices.size() - 1;
    return last <= 0
        ? with("mean", "what", choices.isEmpty() ? phrases.of("something") : choices.get(0))
        : phrases.of(
            "mean-which",
            Map.of(
                "first", String.join(", ", choices.subList(0, last)), "last", choices.get(last)));
  }

  /** Whether that is meant, which could have been said. */
  public String meaning(String said) {
    return with("mean-said", "said", said);
  }

  /** What each is called in that question. */
  public List<String> choices(List<Wish> wishes) {
    return wishes.stream().map(this::choice).toList();
  }

  private String choice(Wish wish) {
    return doing(wish).orElseGet(() -> named(wish));
  }

  private String named(Wish wish) {
    return deed(wish)
        .orElseGet(
            () ->
                wish.said()
                    .map(words -> with("quoted", "words", words))
                    .orElseGet(() -> phrases.of("something")));
  }

  /** What is to be done for it, after "to"; empty when there are no words for it. */
  public Optional<String> deed(Wish wish) {
    return wish.goal().flatMap(deeds::of);
  }

  private Optional<String> doing(Wish wish) {
    return wish.goal().flatMap(deeds::doing);
  }

  private String with(String phrase, String place, String value) {
    return phrases.of(phrase, Map.of(place, value));
  }
}
