package org.maestro.agents.centre;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.references.KeptReference;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Reading;
import org.maestro.dialogue.SpokenWords;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.language.wording.AnswerWords;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * What people say, as an agent hears it that only understands (ADE, 3; A15): what is to be so is
 * stated as goals to another agent, and what is asked is asked of the one that knows. Agent thread
 * only.
 */
public final class Interpreter {
  private static final Duration NO_END = Duration.ofDays(365);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final KnowledgeBase known;
  private final Dialogues dialogues;
  private final KeptReference goals;
  private final KeptReference memory;

  /**
   * @param known the home, and what words refer to
   * @param goals to the agent that pursues them
   * @param memory to the agent that answers questions
   */
  public Interpreter(
      MaestroAgent agent,
      KnowledgeBase known,
      Dialogues dialogues,
      KeptReference goals,
      KeptReference memory) {
    this.agent = agent;
    this.known = known;
    this.dialogues = dialogues;
    this.goals = goals;
    this.memory = memory;
  }

  /** Somebody says something, all of it. */
  public void say(ACLMessage message, Words words) {
    Said.of(agent, known.home(), message, words).ifPresent(this::hear);
  }

  private void hear(Said said) {
    if (said.caller().user().isPresent()) {
      refuse(
          said,
          "On a secured site the central agent understands what is said itself, as it knows who"
              + " says it; say it there.");
      return;
    }
    SpokenWords spoken = dialogues.with(said.person());
    SpokenWords.Hearing heard = spoken.read(said.utterance());
    String means = heard.message().map(SlPrinter::print).orElse("");
    Reading reading = heard.reading().orElse(new Reading.Unclear(notUnderstood(heard), List.of()));
    if (reading instanceof Reading.Goals wanted) {
      Optional<String> refusal =
          wanted.formulas().stream()
              .flatMap(goal -> spoken.refusal(goal, said.utterance()).stream())
              .findFirst();
      refusal.ifPresentOrElse(why -> refuse(said, why), () -> state(said, wanted, means));
    } else if (reading instanceof Reading.Asked asked) {
      ask(said, means, asked.formula(), found -> spoken.answer(found, asked.formula()));
    } else if (reading instanceof Reading.Counted counted) {
      ask(said, means, counted.formula(), found -> spoken.counted(found, counted.formula()));
    } else if (reading instanceof Reading.Back back) {
      agent.reply(said.message(), ACLMessage.INFORM, SayWords.asked(back.text()));
    } else if (reading instanceof Reading.Said reply) {
      agent.reply(said.message(), ACLMessage.INFORM, SayWords.replied(means, reply.text()));
    } else if (reading instanceof Reading.Unclear unclear) {
      refuse(said, unclear.why());
    } else {
      refuse(
          said,
          "That means %s; only the central agent can do something about that.".formatted(means));
    }
  }

  private static String notUnderstood(SpokenWords.Hearing heard) {
    return heard.reply().orElse("That is not understood; say it in other words.");
  }

  private void refuse(Said said, String why) {
    agent.refuse(said.message(), ACLMessage.REFUSE, why);
  }

  private Formula formula(String text) {
    return SlParser.formula(text, known.home().vocabulary()::isFluent);
  }

  private void state(Said said, Reading.Goals wanted, String means) {
    Optional<AID> other = goals.agent();
    if (other.isEmpty()) {
      refuse(said, "That means %s, and nobody has goals now: %s".formatted(means, goals.reason()));
      return;
    }
    StatedElsewhere stated = new StatedElsewhere(agent, said, means, wanted.formulas().size());
    for (String goal : wanted.formulas()) {
      agent.ask(
          agent.message(
              ACLMessage.REQUEST,
              other.get(),
              Words.content(
                  "initCNP",
                  Words.named("goal", Words.formula(formula(goal))),
                  Words.named("speaker", Words.name(said.person())))),
          NO_END,
          stated::answered);
    }
  }

  private void ask(
      Said said, String means, String asked, Function<List<AnswerWords.Found>, String> sentence) {
    Formula formula = formula(asked);
    Consumer<List<AnswerWords.Found>> told =
        found ->
            agent.reply(
                said.message(), ACLMessage.INFORM, SayWords.replied(means, sentence.apply(found)));
    ask(
        said,
        "query-ref",
        formula,
        found -> {
          if (found.isEmpty()) {
            ask(said, "query-if", formula, told);
          } else {
            told.accept(found);
          }
        });
  }

  private void ask(
      Said said, String operator, Formula formula, Consumer<List<AnswerWords.Found>> told) {
    Optional<AID> other = memory.agent();
    if (other.isEmpty()) {
      refuse(said, "Nobody knows anything now: %s".formatted(memory.reason()));
      return;
    }
    agent.ask(
        agent.message(
            ACLMessage.QUERY_REF, other.get(), Words.content(operator, Words.formula(formula))),
        ANSWER_WITHIN,
        answer -> {
          if (answer.getPerformative() == ACLMessage.INFORM) {
            told.accept(found(answer));
          } else if (Conversations.isFinal(answer)) {
            refuse(said, Replies.reason(answer).orElse("The knowledge agent does not answer."));
          }
        });
  }

  private static List<AnswerWords.Found> found(ACLMessage answer) {
    return Words.parse(answer.getContent()).stream()
        .filter(content -> Words.of(content).string("truth").isPresent())
        .map(Interpreter::found)
        .toList();
  }

  private static AnswerWords.Found found(Content content) {
    Words words = Words.of(content);
    Map<String, String> binding = new LinkedHashMap<>();
    words.termsOf("binding").forEach((name, value) -> binding.put(name, Words.plain(value)));
    return AnswerWords.Found.of(
        Truth.valueOf(words.string("truth").orElseThrow().toUpperCase(Locale.ROOT)),
        binding,
        words.find("because").flatMap(because -> because.string("kind")).orElse(""),
        words
            .term("age")
            .filter(Term.Number.class::isInstance)
            .map(age -> OptionalDouble.of(((Term.Number) age).value()))
            .orElse(OptionalDouble.empty()),
        words.number("confidence", 1));
  }
}
