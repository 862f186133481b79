package org.maestro.language;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.maestro.language.chart.Chart;
import org.maestro.language.chart.RuleIndex;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.GrammarFaultException;
import org.maestro.language.grammar.Rule;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.lexicon.ConstructionRules;
import org.maestro.language.lexicon.FittingRoles;
import org.maestro.language.lexicon.Lexicon;
import org.maestro.language.lexicon.LexiconOfHome;
import org.maestro.language.lexicon.Tokens;
import org.maestro.language.lexicon.WholeTexts;
import org.maestro.language.meaning.Wishes;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.RefusalWords;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.permission.GoalObjections;
import org.maestro.sl.Formula;

/**
 * A language of people in a home: its grammar, and the home's words in it. Immutable; any thread
 * may listen by it.
 */
public final class Language {
  private static final String USUAL = "en";

  private final Home home;
  private final Grammar own;
  private final Grammar grammar;
  private final Lexicon lexicon;
  private final RuleIndex rules;
  private final Set<String> grammarWords;
  private final Tokens tokens;
  private final Predicate<Form> possible;
  private final RefusalWords refusals;

  /** Words that others of the home have. */
  private final Set<String> foreign;

  private Language(Grammar own, Home home, Set<String> foreign) {
    this.home = home;
    this.own = own;
    this.foreign = foreign;
    this.grammar = own.with(new ConstructionRules(own).of(home.wording().constructions()));
    this.lexicon = new LexiconOfHome(home, own).read();
    this.rules = new RuleIndex(grammar);
    this.grammarWords = HeardWords.wordsOf(grammar);
    this.tokens = new Tokens(own.spellings());
    this.possible = new FittingRoles(home).and(new WholeTexts(own, home.wording()));
    this.refusals = new RefusalWords(home, grammar);
  }

  /**
   * A language that the home brings, or a shipped one.
   *
   * @param tag such as {@code en}
   */
  public static Language of(Home home, String tag) {
    return of(home, Grammars.of(home, tag));
  }

  /**
   * A language by the text of its grammar, which may be built on a shipped one.
   *
   * @param file how faults call it
   */
  public static Language written(Home home, String text, String file) {
    return of(home, Grammars.read(text, file));
  }

  /**
   * Reads the grammars that the home brings.
   *
   * @throws GrammarFaultException when a line of one cannot be read, or something is missing
   */
  public static void check(Home home) {
    Grammars.check(home);
  }

  /** A language by its grammar. */
  public static Language of(Home home, Grammar grammar) {
    return new Language(grammar, home, Set.of());
  }

  /**
   * The same language as somebody has it who can speak of some topics only. A word that is missing
   * then is not taken for one that sounds alike.
   *
   * @param topics names of topics and of constructions
   */
  public Language about(Set<String> topics) {
    Set<String> others = new HashSet<>(grammarWords);
    others.addAll(lexicon.words());
    return new Language(own, TopicsOfHome.of(home, topics), others);
  }

  /**
   * The tag of the language that somebody speaks: his own, that of the home, or the usual one; only
   * those are spoken that the home brings, or that are shipped.
   */
  public static String spoken(Home home, Optional<String> person) {
    return home.wording()
        .languageOf(person.orElse(""))
        .filter(tag -> Grammars.has(home, tag))
        .orElse(USUAL);
  }

  /** Whether somebody can be understood at home in the language of that tag. */
  public static boolean isUnderstood(Home home, String tag) {
    return Grammars.has(home, tag);
  }

  /** Listens to one utterance. */
  public Listening listen(Situation situation) {
    return new Listening(
        grammar,
        new HeardWords(
            grammar, grammarWords, foreign, lexicon, () -> new Chart(rules, lexicon, possible)),
        situation);
  }

  /** Listens to words after which others may come. */
  public Listening hear(String words, Situation situation) {
    Listening listening = listen(situation);
    words(words).forEach(listening::hear);
    return listening;
  }

  /** Understands a whole utterance. */
  public Understanding understand(String utterance, Situation situation) {
    return hear(utterance, situation).end(utterance).in(new OwnWords(tokens, utterance));
  }

  /**
   * The lines of the grammar by which it is understood what somebody says, as far as they are its
   * rules; none where it is not understood.
   */
  public Set<Integer> rulesOf(String utterance, Situation situation) {
    Listening listening = hear(utterance, situation);
    listening.end(utterance);
    return listening.rules().stream().map(Rule::line).collect(Collectors.toSet());
  }

  /**
   * Words with which what somebody writes could go on; where the text ends within a word, words
   * that begin as that does.
   *
   * @param most so many at most
   */
  public List<String> next(String text, Situation situation, int most) {
    int last = text.length();
    while (last > 0 && !Character.isWhitespace(text.charAt(last - 1))) {
      last--;
    }
    Listening listening = hear(text.substring(0, last), situation);
    List<String> begun = words(text.substring(last));
    return begun.size() > 1 ? List.of() : listening.next(String.join("", begun), most);
  }

  /**
   * Why the speaker may not have done what she asks for, as she is told; empty when nothing is to
   * be said against it.
   */
  public Optional<String> refusal(Understanding understood, Situation situation) {
    return understood.wish().stream()
        .flatMap(message -> Wishes.of(message, situation.home()).stream())
        .flatMap(goal -> refusal(goal, situation).stream())
        .findFirst();
  }

  /** The same of a goal. */
  public Optional<String> refusal(Formula goal, Situation situation) {
    return new GoalObjections(situation.home(), situation.facts())
        .of(goal, situation.speaker())
        .map(refusals::of);
  }

  /** The words of a text. */
  public List<String> words(String text) {
    return tokens.of(text);
  }

  /** All words of the home. */
  public Lexicon lexicon() {
    return lexicon;
  }

  public Grammar grammar() {
    return grammar;
  }
}
