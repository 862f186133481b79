package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.maestro.agents.content.SaidReply;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Reading;
import org.maestro.dialogue.SpokenWords;
import org.maestro.knowledge.Question;
import org.maestro.knowledge.api.Answer;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.language.wording.AnswerWords;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/**
 * What people say, as other agents hear it and tell it the central one (ADE, 4.2): goals are taken
 * on, questions answered, and what could be several things is asked back. Who may have what done or
 * told is who sends it, whoever is said to speak. Agent thread only.
 */
public final class Sayings {
  private static final int MILLIS_PER_SECOND = 1_000;

  private final MaestroAgent agent;
  private final KnowledgeBase knowledge;
  private final GoalRequests requests;
  private final Dialogues dialogues;
  private final Overhearing overhearing;
  private final Undoing undoing;
  private final Faces faces;
  private final Map<String, SaidGoals> lastByPerson = new HashMap<>();

  /**
   * @param dialogues what was said before, also by other ways
   * @param faces at which the agent is seen while it listens and answers
   */
  public Sayings(
      MaestroAgent agent,
      KnowledgeBase knowledge,
      Coordinator coordinator,
      GoalRequests requests,
      Undoing undoing,
      Dialogues dialogues,
      Faces faces) {
    this.agent = agent;
    this.knowledge = knowledge;
    this.requests = requests;
    this.undoing = undoing;
    this.dialogues = dialogues;
    this.faces = faces;
    this.overhearing = new Overhearing(agent, knowledge, coordinator, requests, dialogues, faces);
  }

  /** Somebody says something. */
  public void say(ACLMessage message, Words words) {
    Said.of(agent, knowledge.home(), message, words).ifPresent(this::hear);
  }

  /** The same, of what was read already. */
  public void hear(Said said) {
    if (said.words().string("more").filter("true"::equals).isPresent()) {
      overhearing.hear(said);
      return;
    }
    dialogues
        .asked()
        .answeredBy(said.utterance())
        .ifPresentOrElse(question -> answer(said, question), () -> understand(said));
  }

  /** It is the answer to a script, if that still waits for one. */
  private void answer(Said said, Speech question) {
    overhearing.over(said, List.of(), List.of());
    if (!requests.mayAsk(said.caller(), said.message())) {
      return;
    }
    requests.answer(
        question.part(),
        dialogues.answer(said.utterance(), question),
        said.caller(),
        Optional.of(said.person()),
        (performative, contents) -> {
          boolean isOver =
              Stream.of(contents)
                  .flatMap(one -> Words.of(one).string("open").stream())
                  .anyMatch("false"::equals);
          if (isOver || performative == ACLMessage.INFORM) {
            dialogues.asked().over(question);
          }
          if (isOver) {
            understand(said);
          } else {
            reply(said, performative, contents);
          }
        });
  }

  private void understand(Said said) {
    SpokenWords spoken = dialogues.with(said.person());
    SpokenWords.Hearing heard = spoken.read(said.utterance());
    String means = heard.message().map(SlPrinter::print).orElse("");
    Reading reading = heard.reading().orElse(new Reading.Unclear(notUnderstood(heard), List.of()));
    if (reading instanceof Reading.Goals goals && refusal(spoken, goals, said).isEmpty()) {
      state(said, heard, goals, means);
      return;
    }
    overhearing.over(said, List.of(), List.of());
    if (reading instanceof Reading.Goals goals) {
      refuse(said, refusal(spoken, goals, said).orElseThrow());
    } else if (reading instanceof Reading.Asked asked) {
      tell(said, means, asked.formula(), answers -> spoken.answer(answers, asked.formula()));
    } else if (reading instanceof Reading.Counted counted) {
      tell(said, means, counted.formula(), answers -> spoken.counted(answers, counted.formula()));
    } else if (reading instanceof Reading.Back back) {
      reply(said, ACLMessage.INFORM, SayWords.asked(back.text()));
    } else if (reading instanceof Reading.Said reply) {
      reply(said, ACLMessage.INFORM, SayWords.replied(means, reply.text()));
    } else if (reading instanceof Reading.Undone) {
      undo(said, spoken, means);
    } else if (isNothingToDo(reading, heard)) {
      reply(
          said,
          ACLMessage.INFORM,
          SayWords.replied(means, spoken.goals(said.utterance()).phrase("no")));
    } else if (reading instanceof Reading.Agreed) {
      refuse(said, notUnderstood(heard));
    } else if (reading instanceof Reading.Unclear unclear) {
      refuse(said, unclear.why());
    } else {
      refuse(said, ofTheConsole(means));
    }
  }

  /** It is told to who has told the words, and seen by who spoke them. */
  private void reply(Said said, int performative, Content... contents) {
    agent.reply(said.message(), performative, contents);
    faces.answered(said.utterance(), SayWords.read(List.of(contents)));
  }

  private void refuse(Said said, String why) {
    agent.refuse(said.message(), ACLMessage.REFUSE, why);
    faces.answered(said.utterance(), new SaidReply.Refused(why));
  }

  private void state(Said said, SpokenWords.Hearing heard, Reading.Goals goals, String means) {
    List<Formula> formulas = goals.formulas().stream().map(this::formula).toList();
    UnfinishedSentence sentence = overhearing.over(said, heard.begun(), formulas);
    if (!state(said, formulas, sentence, means)) {
      overhearing.takeBack(sentence, said);
    }
  }

  private boolean state(
      Said said, List<Formula> formulas, UnfinishedSentence sentence, String means) {
    SaidGoals stated =
        new SaidGoals(
            formulas,
            sentence,
            means,
            (performative, contents) -> reply(said, performative, contents));
    lastByPerson.put(said.person(), stated);
    return requests.state(said, stated);
  }

  /** What she has asked for last is called off, and is to be as it was. */
  private void undo(Said said, SpokenWords spoken, String means) {
    List<String> last =
        undoing.last(
            said.person(),
            Optional.ofNullable(lastByPerson.get(said.person()))
                .map(SaidGoals::accepted)
                .orElse(List.of()));
    Consumer<String> reply =
        phrase ->
            reply(
                said,
                ACLMessage.INFORM,
                SayWords.replied(means, spoken.goals(said.utterance()).phrase(phrase)));
    if (last.isEmpty()) {
      reply.accept("undo-nothing");
      return;
    }
    undoing.callOff(
        last,
        said.caller().toString(),
        former ->
            former
                .wish()
                .ifPresentOrElse(
                    wish -> state(said, List.of(wish), new UnfinishedSentence(), means),
                    () ->
                        reply.accept(
                            former.unknown().isEmpty() ? "undo-nothing" : "undo-unknown")));
  }

  /** A no, or that what was asked back is left so. */
  private static boolean isNothingToDo(Reading reading, SpokenWords.Hearing heard) {
    return reading instanceof Reading.Agreed agreed && !agreed.yes()
        || reading instanceof Reading.CalledOff off && off.formula().isEmpty() && heard.answering();
  }

  /** What is asked about goals, called off or tried again needs who has followed them. */
  private static String ofTheConsole(String means) {
    return ("That means %s; what is asked about goals, called off or tried again is answered in the"
            + " chat of the console and by ./maestro say alone.")
        .formatted(means);
  }

  /** Where she may not have a part done, nothing of the whole is begun. */
  private static Optional<String> refusal(SpokenWords spoken, Reading.Goals goals, Said said) {
    return goals.formulas().stream()
        .flatMap(goal -> spoken.refusal(goal, said.utterance()).stream())
        .findFirst();
  }

  /** Why nothing comes of it. */
  private static String notUnderstood(SpokenWords.Hearing heard) {
    return heard
        .message()
        .map(
            message ->
                "That means %s, and nothing can be done about it here."
                    .formatted(SlPrinter.print(message)))
        .or(heard::reply)
        .orElse("That is not understood; say it in other words.");
  }

  private Formula formula(String text) {
    return SlParser.formula(text, knowledge.home().vocabulary()::isFluent);
  }

  private void tell(
      Said said, String means, String asked, Function<List<AnswerWords.Found>, String> sentence) {
    Formula formula = formula(asked);
    ReadingRights rights = requests.rights(said.message(), said.words());
    Optional<String> objection = rights.objection(formula);
    if (objection.isPresent()) {
      refuse(said, objection.get());
      return;
    }
    Question question = new Question(knowledge.snapshot(), rights);
    List<Answer> bound = likely(question, formula, rights);
    List<Answer> answers = bound.isEmpty() ? List.of(question.answerIf(formula)) : bound;
    reply(
        said,
        ACLMessage.INFORM,
        SayWords.replied(means, sentence.apply(answers.stream().map(Sayings::found).toList())));
  }

  /** The answers that are known; where more are only likely, these. */
  private List<Answer> likely(Question question, Formula formula, ReadingRights rights) {
    List<Answer> known = question.answerRef(formula);
    return knowledge
        .home()
        .tracking()
        .flatMap(tracking -> tracking.supposed(formula))
        .filter(supposed -> rights.objection(supposed).isEmpty())
        .map(question::answerRef)
        .filter(likely -> likely.size() > known.size())
        .orElse(known);
  }

  private static AnswerWords.Found found(Answer answer) {
    Map<String, String> binding = new LinkedHashMap<>();
    answer.binding().forEach((name, value) -> binding.put(name, Words.plain(value)));
    return AnswerWords.Found.of(
        answer.truth(),
        binding,
        answer.because().stream()
            .findFirst()
            .map(belief -> belief.source().kind().name().toLowerCase(Locale.ROOT))
            .orElse(""),
        answer
            .age()
            .map(age -> OptionalDouble.of((double) age.toMillis() / MILLIS_PER_SECOND))
            .orElse(OptionalDouble.empty()),
        answer.confidence());
  }
}
