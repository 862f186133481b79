package org.maestro.coordination.scripts;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.api.Speech;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * What the parts of one script say to people and tell agents, and the questions that are open. The
 * coordinator's thread only.
 */
final class Voice {
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final Formula goal;
  private final Notes notes;
  private final ScriptStory told;
  private final OpenQuestions questions = new OpenQuestions();

  /**
   * @param goal that asks for the script
   */
  Voice(Ports ports, ActiveGoals activeGoals, Formula goal, Notes notes, ScriptStory told) {
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.goal = goal;
    this.notes = notes;
    this.told = told;
  }

  /**
   * What was done before is written down first, so that only this is said again after a restart.
   *
   * @param then told nothing when it is where people hear it, or else why not
   */
  void say(String path, String who, List<Term> words, Consumer<Optional<String>> then) {
    Speech speech =
        new Speech(notes.partId(path), who, Sentence.of(words, ports.knowledge().home()));
    Consumer<Optional<String>> answered =
        problem -> {
          if (problem.isEmpty()) {
            told.says(path, who, speech.text());
          }
          activeGoals.run(() -> then.accept(problem));
        };
    ports.journal().afterwards(() -> ports.messenger().say(speech, answered));
  }

  /**
   * The same, of an agent and a message.
   *
   * @param then told nothing when the agent has taken it, or else why not
   */
  void tell(String path, String agent, Content message, Consumer<Optional<String>> then) {
    told.tells(path, agent, SlPrinter.print(message));
    Consumer<Optional<String>> answered = problem -> activeGoals.run(() -> then.accept(problem));
    ports
        .journal()
        .afterwards(() -> ports.messenger().tell(notes.partId(path), agent, message, answered));
  }

  /**
   * The same, of a question, which is open from now on.
   *
   * @param failed told why nobody could be asked
   */
  void ask(String path, Question question, Consumer<String> failed) {
    questions.ask(path, question);
    Home home = ports.knowledge().home();
    Speech speech =
        new Speech(
            notes.partId(path),
            question.who(),
            Sentence.of(question.words(), home),
            Optional.of(question.answers(home).wanted()));
    Consumer<Optional<String>> asked =
        problem -> {
          if (problem.isEmpty()) {
            told.asks(path, speech);
          } else if (questions.isOpen(path)) {
            questions.withdraw(path);
            activeGoals.run(() -> failed.accept(problem.get()));
          }
        };
    ports
        .journal()
        .afterwards(
            () -> {
              if (questions.isOpen(path)) {
                ports.messenger().say(speech, asked);
              }
            });
  }

  /**
   * An answer is kept beyond the script.
   *
   * @param then run once it is, or cannot be
   */
  void keep(String path, String to, List<Term> words, Term answer, Respondent by, Runnable then) {
    GivenAnswer given =
        new GivenAnswer(
            ports.clock().instant(),
            goal instanceof Formula.Atom atom ? atom.predicate() : "",
            SlPrinter.print(goal),
            notes.partId(path),
            to,
            by,
            Sentence.of(words, ports.knowledge().home()),
            Sentence.plain(answer));
    ports.messenger().keep(given, () -> activeGoals.run(then));
  }

  /** A mood is shown as something is said. */
  void express(String path, String word, double intensity, Consumer<Optional<String>> then) {
    Mood mood = new Mood(notes.partId(path), word, intensity);
    Consumer<Optional<String>> shown =
        problem -> {
          if (problem.isEmpty()) {
            told.expresses(path, mood);
          }
          activeGoals.run(() -> then.accept(problem));
        };
    ports.journal().afterwards(() -> ports.messenger().show(mood, shown));
  }

  void withdraw(String path) {
    questions.withdraw(path);
  }

  /** See {@link OpenQuestions#answer}. */
  void answer(String path, String text, Respondent by, Consumer<Optional<AnswerRefusal>> then) {
    questions.answer(path, notes.partId(path), text, by, ports.knowledge().home(), then);
  }

  /** Questions that wait for an answer, in words. */
  List<String> openQuestions() {
    return questions.inWords(ports.knowledge().home());
  }
}
