package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.agents.content.OverheardReply;
import org.maestro.agents.faces.Faces;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.Coordinator;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Overheard;
import org.maestro.dialogue.Reading;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/**
 * Acts while somebody is speaking: what is certain and may be begun before the end is begun, and
 * undone when the words are taken back or nothing follows. Agent thread only.
 *
 * <p>Source: ADE, 2 and 4.2 (A12, A60, A63).
 */
final class Overhearing {
  /**
   * Who has said nothing for so long has broken off. People speak in wall time however fast the
   * world goes, and those of a scenario in simulated time: it is not less than so much of either.
   */
  private static final Duration SILENCE = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final KnowledgeBase knowledge;
  private final Coordinator coordinator;
  private final GoalRequests requests;
  private final Dialogues dialogues;
  private final Faces faces;
  private final Map<String, UnfinishedSentence> byPerson = new HashMap<>();

  Overhearing(
      MaestroAgent agent,
      KnowledgeBase knowledge,
      Coordinator coordinator,
      GoalRequests requests,
      Dialogues dialogues,
      Faces faces) {
    this.agent = agent;
    this.knowledge = knowledge;
    this.coordinator = coordinator;
    this.requests = requests;
    this.dialogues = dialogues;
    this.faces = faces;
  }

  /** Words were heard, all of the sentence so far; others are to come. */
  void hear(Said said) {
    if (!requests.mayAsk(said.caller(), said.message())) {
      return;
    }
    Overheard heard = overhear(said);
    UnfinishedSentence sentence =
        byPerson.computeIfAbsent(said.person(), person -> new UnfinishedSentence());
    awaitSilence(sentence, said);
    List<String> undone = takeBack(sentence, allowed(said, heard), said);
    List<BegunGoal> begun = sentence.begin();
    begun.forEach(goal -> requests.begin(said, goal.goal(), goal, goal::ended));
    Runnable answer = () -> answer(said, heard, sentence, undone);
    if (begun.isEmpty()) {
      answer.run();
    }
    Answered answered = new Answered(begun.size(), answer);
    begun.forEach(goal -> goal.tell(answered));
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

  /** The words are answered once it is certain what was begun. */
  private void answer(
      Said said, Overheard heard, UnfinishedSentence sentence, List<String> undone) {
    agent.reply(
        said.message(),
        ACLMessage.INFORM,
        new OverheardReply(
                heard.looks(), heard.complete(), sentence.ids(), undone, Optional.empty())
            .content());
    faces.overheard(said.utterance(), heard.looks(), heard.complete());
  }

  /** Whether each of some goals is taken on, or not, has been told. */
  private static final class Answered implements Coordinator.Answer {
    private final Runnable then;
    private int awaited;

    Answered(int awaited, Runnable then) {
      this.awaited = awaited;
      this.then = then;
    }

    @Override
    public void accepted(String goalId) {
      told();
    }

    @Override
    public void refused(String reason) {
      told();
    }

    private void told() {
      awaited--;
      if (awaited == 0) {
        then.run();
      }
    }
  }

  /** A word that is heard as the time is up comes first. */
  private void awaitSilence(UnfinishedSentence sentence, Said said) {
    int heard = sentence.heard();
    sentence.waits(
        agent
            .clock()
            .schedule(
                agent.clock().ofWallAtLeast(SILENCE),
                said.person(),
                () ->
                    agent.tell(
                        () -> {
                          if (sentence.isSilentSince(heard)) {
                            over(said, List.of(), List.of());
                          }
                        })));
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
    sentence.heard();
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
    List<BegunGoal> unwanted = sentence.wants(wanted);
    unwanted.forEach(goal -> goal.tell(new TakenBack(sentence, said)));
    return unwanted.stream().flatMap(goal -> goal.id().stream()).toList();
  }

  /** Calls a goal off once it is taken on, and has it be as it was. */
  private final class TakenBack implements Coordinator.Answer {
    private final UnfinishedSentence sentence;
    private final Said said;

    TakenBack(UnfinishedSentence sentence, Said said) {
      this.sentence = sentence;
      this.said = said;
    }

    @Override
    public void accepted(String goalId) {
      coordinator.cancel(goalId, said.caller().toString());
      coordinator.beforeGoal(
          goalId,
          sentence::wanted,
          former ->
              former
                  .wish()
                  .ifPresent(
                      wish -> requests.begin(said, wish, Coordinator.Answer.NOBODY, end -> {})));
    }

    @Override
    public void refused(String reason) {
      // Nothing was begun.
    }
  }
}
