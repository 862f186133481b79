package org.maestro.language;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.language.chart.Chart;
import org.maestro.language.chart.Reading;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.hearing.Heard;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.lexicon.Lexicon;
import org.maestro.language.meaning.Doubt;
import org.maestro.language.meaning.Interpreter;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.QuestionsBack;
import org.maestro.sl.Content;

/** Listens to one utterance, word by word. Not safe for threads. */
public final class Listening {
  /**
   * Of so few words what is lacking is asked for; of more it is likelier that it was meant
   * otherwise.
   */
  private static final int FEW_WORDS = 5;

  /** Of so many words it may be that they do not matter. */
  private static final int FEW_UNKNOWN = 2;

  private final Grammar grammar;
  private final HeardWords words;
  private Situation situation;
  private Interpreter interpreter;
  private final Beginning beginning = new Beginning();
  private int repairs;
  private boolean isComplete;
  private Optional<Meaning> lastSaid = Optional.empty();

  Listening(Grammar grammar, HeardWords words, Situation situation) {
    this.grammar = grammar;
    this.words = words;
    this.situation = situation;
    this.interpreter = interpreter();
  }

  /** Takes the next word. */
  public void hear(String word) {
    words.take(word);
    if (words.repairs() > repairs) {
      repairs = words.repairs();
      // What is taken back was spoken of all the same.
      lastSaid.ifPresent(
          said -> situation = situation.after(Understanding.spokenOf(said, situation.discourse())));
      beginning.callOff(word);
      interpreter = interpreter();
    }
    List<Meaning> now = soFar();
    lastSaid = now.isEmpty() ? lastSaid : now.stream().findFirst();
    Optional<Meaning> best = best(now);
    // A word alone may be a verb, too: who lowers the blinds wants no music lower.
    boolean isOpen =
        best.isPresent() && (words.chart().size() == 1 || mayBeOfSomethingElse(words.chart()));
    best.ifPresent(meaning -> beginning.understood(word, meaning, isOpen));
    if (word.codePoints().anyMatch(Character::isLetterOrDigit)) {
      isComplete = best.flatMap(Meaning::message).isPresent();
    }
  }

  /** What a number is of may still follow it, or that it is a difference: two degrees warmer. */
  private static boolean mayBeOfSomethingElse(Chart chart) {
    return chart.isOpenAfter(Lexicon.NUMBER)
        || chart.isOpenAfter(Lexicon.AMOUNT)
            && (chart.predicts(Lexicon.MORE) || chart.predicts(Lexicon.LESS));
  }

  /** The best meaning of what was said so far, if it is certain. */
  private static Optional<Meaning> best(List<Meaning> meanings) {
    return meanings.stream()
        .findFirst()
        .filter(one -> one.broken() == 0 && one.doubt().isEmpty() && !isAmbiguous(meanings));
  }

  /** What was said so far may mean, if it ended here; the best first. */
  public List<Meaning> soFar() {
    return preferred(interpreter.of(words.readings()));
  }

  private Interpreter interpreter() {
    Set<String> idle =
        grammar.list("idle").stream()
            .map(words -> String.join(" ", words))
            .collect(Collectors.toSet());
    return new Interpreter(situation, idle);
  }

  /** The readings that are under way, with what may still be meant. */
  public List<Understanding.UnderWay> underWay() {
    return words.isBlocked()
        ? List.of()
        : new Narrowing(situation).of(words.chart().partial(Narrowing::isBegun));
  }

  /** The individuals that alone can be meant by what was said so far. */
  public List<String> attention() {
    List<Understanding.UnderWay> readings = underWay();
    return isComplete ? Attention.ofBest(readings) : Attention.of(readings);
  }

  /** Whether it is certain what is wanted, if nothing else follows; a comma changes nothing. */
  public boolean isComplete() {
    return isComplete;
  }

  /** What may be begun before the end, and what of it is called off by words that followed. */
  public List<Understanding.Begun> began() {
    return beginning.began();
  }

  /**
   * Words that could come next, and begin so; none while a word fits nothing.
   *
   * @param begin of them; "" of whichever
   * @param most so many at most
   */
  public List<String> next(String begin, int most) {
    return words.next(begin, most);
  }

  /** The words so far, and what became of them. */
  public List<Heard> heard() {
    return words.heard();
  }

  /** Nothing more is said. */
  public Understanding end(String utterance) {
    words.end();
    List<Meaning> meanings = soFar();
    if (meanings.isEmpty()) {
      meanings = lackingARole();
    }
    if (meanings.isEmpty()) {
      meanings = withoutWhatIsUnknown();
    }
    meanings = preferred(meanings);
    Optional<Meaning> best = meanings.stream().findFirst();
    Optional<Doubt> doubt = best.flatMap(Meaning::doubt);
    boolean isAmbiguous = best.isPresent() && isAmbiguous(meanings);
    Optional<Content> message =
        doubt.isPresent() || isAmbiguous ? Optional.empty() : best.flatMap(Meaning::message);
    List<Heard> all = words.heard();
    beginning.end(message, all.isEmpty() ? "" : all.get(all.size() - 1).word());
    QuestionsBack questions = new QuestionsBack(situation, grammar);
    List<Meaning> tied = meanings.isEmpty() ? List.of() : tied(meanings);
    Optional<String> question =
        isAmbiguous
            ? Optional.of(questions.between(tied(meanings)))
            : doubt.map(why -> questions.of(why, doubts(tied)));
    return new Understanding(
        utterance,
        message,
        question,
        reply(best, message, question),
        words.heard(),
        meanings,
        beginning.began(),
        coverage());
  }

  /** The rules by which it was understood what was said; none where it was not. */
  Set<Rule> rules() {
    return soFar().stream()
        .findFirst()
        .flatMap(
            best ->
                words.readings().stream().filter(one -> one.form().equals(best.form())).findFirst())
        .map(words.chart()::rules)
        .orElse(Set.of());
  }

  /** What was said until a word that is not understood, where only a role is missing then. */
  private List<Meaning> lackingARole() {
    boolean isMisplaced =
        words.heard().stream().anyMatch(word -> word.fate() == Heard.Fate.UNPLACED);
    boolean isCutOff = words.heard().stream().anyMatch(word -> word.fate() == Heard.Fate.UNKNOWN);
    if (isMisplaced || !isCutOff && words.chart().size() > FEW_WORDS) {
      return List.of();
    }
    // Whatever may be told to somebody is no sign that it was meant so.
    List<Reading> lacking =
        words.chart().begun("frame").stream()
            .filter(reading -> !isLackingMore(reading.form()))
            .toList();
    return interpreter.of(lacking).stream()
        .filter(meaning -> meaning.doubt().filter(Doubt.Missing.class::isInstance).isPresent())
        .toList();
  }

  /** What is meant if a word or two that nobody knows are left out: it is asked whether it is. */
  private List<Meaning> withoutWhatIsUnknown() {
    List<String> unknown = unknown();
    List<String> known =
        words.heard().stream()
            .filter(word -> word.fate() != Heard.Fate.UNKNOWN)
            .map(Heard::word)
            .toList();
    if (unknown.isEmpty() || unknown.size() > FEW_UNKNOWN || known.size() < 2 * unknown.size()) {
      return List.of();
    }
    HeardWords without = words.afresh();
    known.forEach(without::take);
    without.end();
    String said = String.join(" ", known);
    return interpreter.of(without.readings()).stream()
        .limit(1)
        .filter(
            meaning ->
                meaning.message().isPresent()
                    || meaning.doubt().filter(Doubt.Which.class::isInstance).isPresent())
        .map(meaning -> meaning.doubted(new Doubt.LeftOut(unknown, said)))
        .toList();
  }

  /** Whether more is open than what is to fill a role. */
  private static boolean isLackingMore(Form form) {
    if (form.is("role")) {
      return !form.part(1).equals(Form.HOLE) && isLackingMore(form.part(1));
    }
    return form.is("text")
        || form.equals(Form.HOLE)
        || form.parts().stream().anyMatch(Listening::isLackingMore);
  }

  /** Two readings that are as good, and mean something else: nobody knows which is meant. */
  private static boolean isAmbiguous(List<Meaning> meanings) {
    return meanings.get(0).message().isPresent()
        && tied(meanings).stream()
                .map(Meaning::message)
                .flatMap(Optional::stream)
                .distinct()
                .count()
            > 1;
  }

  private static List<Doubt> doubts(List<Meaning> meanings) {
    return meanings.stream().map(Meaning::doubt).flatMap(Optional::stream).toList();
  }

  /** Those that are as good as the best. */
  private static List<Meaning> tied(List<Meaning> meanings) {
    Meaning best = meanings.get(0);
    return meanings.stream()
        .filter(one -> one.broken() == best.broken() && one.penalty() == best.penalty())
        .toList();
  }

  /**
   * Of those that are as good the ones that speak of the kind of thing that was spoken of last; and
   * of two that mean the same the one that is asked back.
   */
  private List<Meaning> preferred(List<Meaning> meanings) {
    if (meanings.size() < 2) {
      return meanings;
    }
    List<Meaning> tied = tied(meanings);
    List<Meaning> chosen = tied;
    for (String kind : situation.discourse().classes()) {
      List<Meaning> familiar = tied.stream().filter(one -> one.classes().contains(kind)).toList();
      if (!familiar.isEmpty() && familiar.size() < tied.size()) {
        chosen = familiar;
        break;
      }
    }
    List<Meaning> ordered = new ArrayList<>(chosen);
    ordered.sort(Comparator.comparing(one -> one.doubt().isEmpty()));
    meanings.stream().filter(one -> !tied.contains(one)).forEach(ordered::add);
    return ordered;
  }

  /** What is said when there is neither something to do nor to ask. */
  private Optional<String> reply(
      Optional<Meaning> best, Optional<Content> message, Optional<String> question) {
    if (message.isPresent() || question.isPresent()) {
      return Optional.empty();
    }
    return Optional.of(
        best.map(Meaning::form)
            .map(Form::head)
            .filter(head -> head.equals("greet") || head.equals("thank") || head.equals("no"))
            .map(grammar::phrase)
            .orElseGet(this::notUnderstood));
  }

  private String notUnderstood() {
    return words.isTooLong()
        ? grammar.phrase("too-long")
        : unknown().isEmpty() ? notPlaced() : unknownWords();
  }

  private String notPlaced() {
    return words.heard().stream()
        .filter(word -> word.fate() == Heard.Fate.UNPLACED)
        .findFirst()
        .filter(word -> words.isOfTheHome(word.word()))
        .map(word -> grammar.phrase("not-placed").replace("{word}", word.word()))
        .orElseGet(() -> grammar.phrase("not-understood"));
  }

  private List<String> unknown() {
    return words.heard().stream()
        .filter(word -> word.fate() == Heard.Fate.UNKNOWN)
        .map(Heard::word)
        .toList();
  }

  private String unknownWords() {
    return grammar.phrase("unknown-word").replace("{word}", String.join(" ", unknown()));
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
