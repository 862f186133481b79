package org.maestro.agents.rooms;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SaidReply;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Utterance;
import org.maestro.language.wording.GoalWords;
import org.maestro.language.wording.Wish;
import org.maestro.sl.Formula;

/** What is answered to what was heard in a room, as sentences that are said there. */
final class SpokenReplies {
  private final Dialogues dialogues;
  private final Utterance own;
  private final SpeechStations stations;
  private final RoomVoice voice;

  /**
   * @param own something that the room's agent says itself, in its room
   */
  SpokenReplies(Dialogues dialogues, Utterance own, SpeechStations stations, RoomVoice voice) {
    this.dialogues = dialogues;
    this.own = own;
    this.stations = stations;
    this.voice = voice;
  }

  /** The words in which the room speaks. */
  GoalWords words() {
    return dialogues.with(own.person()).goals(own);
  }

  /** Another agent, or the room's own, has answered; what is reached is told by itself. */
  void answered(Utterance said, ACLMessage reply) {
    if (Replies.isFromPlatform(reply)) {
      return;
    }
    SaidReply told = SayWords.read(Words.parse(reply.getContent()));
    answer(said, told instanceof SaidReply.PassedOn passed ? passed.answer() : told);
  }

  private void answer(Utterance said, SaidReply reply) {
    if (reply instanceof SaidReply.TakenOn taken) {
      stations.at(SpeechStations.MESSAGE, taken.means());
      stations.at(SpeechStations.GOALS, String.join(" ", taken.goals()));
      tell(words().accepted(wish(said, taken.means())));
    } else if (reply instanceof SaidReply.Over over && !over.reached()) {
      tell(words().failed(wish(said, ""), reasons(over)));
    } else if (reply instanceof SaidReply.Replied replied) {
      stations.at(SpeechStations.MESSAGE, replied.means());
      tell(replied.text());
    } else if (reply instanceof SaidReply.Asked asked) {
      tell(asked.question());
    } else if (reply instanceof SaidReply.Refused refused) {
      tell(refused.why());
    }
  }

  private static List<String> reasons(SaidReply.Over over) {
    return over.ends().stream().flatMap(end -> end.reasons().stream()).toList();
  }

  private static Wish wish(Utterance said, String means) {
    Optional<Formula> goal =
        means.startsWith("(initCNP")
            ? Words.of(Words.parse(means).get(0)).find("goal").flatMap(Words::formula)
            : Optional.empty();
    return new Wish(goal, Optional.of(said.text()), Optional.of(said.person()), Duration.ZERO);
  }

  private void tell(String sentence) {
    stations.at(SpeechStations.ANSWER, sentence);
    voice.say(sentence);
  }
}
