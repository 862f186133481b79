package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.agents.content.OverheardReply;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Overheard;
import org.maestro.dialogue.Reading;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/**
 * Acts while somebody is speaking: what is certain and may be begun before the end is begun, and
 * undone when the words are taken back or nothing follows. Agent thread only.
 *
 * <p>Source: ADE, 2 and 4.2 (A12, A60, A63).
 */
final class Overhearing {
  /** Who has said nothing for so long has broken off. */
  private static final Duration SILENCE = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final KnowledgeBase knowledge;
  private final Coordinator coordinator;
  private final GoalRequests requests;
  private final Dialogues dialogues;
  private final Map<String, UnfinishedSentence> byPerson = new HashMap<>();

  Overhearing(
      MaestroAgent agent,
      KnowledgeBase knowledge,
      Coordinator coordinator,
      GoalRequests requests,
      Dialogues dialogues) {
    this.agent = agent;
    this.knowledge = knowledge;
    this.coordinator = coordinator;
    this.requests = requests;
    this.dialogues = dialogues;
  }

  /** Words were heard, all of the sentence so far; others are to come. */
  void hear(Said said) {
    if (!requests.mayAsk(said.caller(), said.message())) {
      return;
    }
    Overheard heard = overhear(said);
    UnfinishedSentence sentence =
        byPerson.computeIfAbsent(said.person(), person -> new UnfinishedSentence());
    sentence.heard(Optional.of(silence(said)));
    List<String> undone = takeBack(sentence, allowed(said, heard), said);
    Answers answers = new Answers(said, heard, sentence, undone);
    List<Formula> missing = sentence.missing();
    answers.await(missing.size());
    missing.forEach(goal -> begin(said, goal, sentence, answers));
  }

  private Overheard overhear(Said said) {
    boolean isNoSpeech =
        said.utterance().text().startsWith("(")
            || dialogues.asked().answeredBy(said.utterance()).isPresent();
    return isNoSpeech
        ? Overheard.NOTHING
        : dialogues.with(said.person()).overhear(said.utterance());
  }

  /** What she may have done by who tells it. */
  private List<Formula> allowed(Said said, Overheard heard) {
    return heard.begun().stream()
        .flatMap(goals -> goals.formulas().stream())
        .filter(goal -> dialogues.with(said.person()).refusal(goal, said.utterance()).isEmpty())
        .map(this::formula)
        .filter(goal -> requests.maySpeakOf(said, goal))
        .distinct()
        .toList();
  }

  private Formula formula(String text) {
    return SlParser.formula(text, knowledge.home().vocabulary()::isFluent);
  }

  private void begin(Said said, Formula goal, UnfinishedSentence sentence, Answers answers) {
    BegunGoal[] begun = new BegunGoal[1];
    Optional<String> id =
        requests.begin(
            said,
            goal,
            answers.to(goal),
            outcome -> Optional.ofNullable(begun[0]).ifPresent(one -> one.ended(outcome)));
    id.ifPresentOrElse(
        name -> {
          begun[0] = new BegunGoal(name, goal, said.requester());
          sentence.begun(begun[0]);
        },
        () -> answers.told(() -> {}));
  }

  /** Answers the words once it is certain what was begun. */
  private final class Answers {
    private final Said said;
    private final Overheard heard;
    private final UnfinishedSentence sentence;
    private final List<String> undone;
    private int awaited;

    Answers(Said said, Overheard heard, UnfinishedSentence sentence, List<String> undone) {
      this.said = said;
      this.heard = heard;
      this.sentence = sentence;
      this.undone = undone;
    }

    void await(int goals) {
      awaited = goals;
      answer();
    }

    /** The answer to one of them. */
    Coordinator.Answer to(Formula goal) {
      return new Coordinator.Answer() {
        @Override
        public void accepted(String goalId) {
          told(() -> {});
        }

        @Override
        public void refused(String reason) {
          told(() -> sentence.forget(goal));
        }
      };
    }

    /** It may be told before the goal has its name. */
    void told(Runnable first) {
      agent.tell(
          () -> {
            first.run();
            awaited--;
            answer();
          });
    }

    private void answer() {
      if (awaited == 0) {
        awaited = -1;
        agent.reply(
            said.message(),
            ACLMessage.INFORM,
            new OverheardReply(
                    heard.looks(), heard.complete(), sentence.ids(), undone, Optional.empty())
                .content());
      }
    }
  }

  private Clock.Timer silence(Said said) {
    return agent
        .clock()
        .schedule(SILENCE, said.person(), () -> agent.tell(() -> over(said, List.of(), List.of())));
  }

  /**
   * Nothing more is said: what was begun and does not belong to it is undone.
   *
   * @param begun goals that belong to what was said
   * @param meant all that is to be so
   * @return what was begun of that
   */
  UnfinishedSentence over(Said said, List<Reading.Goals> begun, List<Formula> meant) {
    UnfinishedSentence sentence =
        Optional.ofNullable(byPerson.remove(said.person())).orElseGet(UnfinishedSentence::new);
    sentence.heard(Optional.empty());
    List<Formula> wanted =
        Stream.concat(
                begun.stream().flatMap(goals -> goals.formulas().stream()).map(this::formula),
                meant.stream())
            .toList();
    takeBack(sentence, wanted, said);
    return sentence;
  }

  /** All that was begun for it is undone. */
  void takeBack(UnfinishedSentence sentence, Said said) {
    takeBack(sentence, List.of(), said);
  }

  private List<String> takeBack(UnfinishedSentence sentence, List<Formula> wanted, Said said) {
    List<String> undone = new ArrayList<>();
    for (BegunGoal goal : sentence.wants(wanted)) {
      undone.add(goal.id());
      coordinator.cancel(goal.id(), said.caller().toString());
      coordinator.beforeGoal(
          goal.id(),
          sentence::wanted,
          former ->
              former
                  .wish()
                  .ifPresent(
                      wish ->
                          requests.begin(said, wish, Coordinator.Answer.NOBODY, outcome -> {})));
    }
    return undone;
  }
}
