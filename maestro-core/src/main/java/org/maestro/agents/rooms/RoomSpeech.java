package org.maestro.agents.rooms;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.OverheardReply;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.SpeechWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Dialogues;
import org.maestro.dialogue.Utterance;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The ears and the voice of a room's agent: what its members hear is said to it, word by word, and
 * what it answers is said by its members that speak. Who can hear no more says so (ADE, 3.2; A38).
 * Agent thread only.
 */
public final class RoomSpeech {
  private static final Logger LOG = LoggerFactory.getLogger(RoomSpeech.class);

  /** The routine of members that hear. */
  private static final String LISTEN = "listen";

  private static final Duration NO_END = Duration.ofDays(365);

  /** Who is lost is often there again after so long, started anew or on another host. */
  private static final Duration COMES_BACK = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final String name;
  private final String room;
  private final Supplier<Home> home;
  private final Map<String, Ear> ears = new TreeMap<>();
  private final SpeechStations stations;
  private final RoomVoice voice;
  private final SpokenReplies replies;
  private final Set<String> missed = new HashSet<>();
  private final Map<String, Clock.Timer> awaited = new TreeMap<>();
  private int complaints;

  /**
   * @param name the agent's, as the home has it
   * @param room in which it hears
   * @param dialogues has the words in which it speaks
   */
  public RoomSpeech(
      MaestroAgent agent, String name, String room, Supplier<Home> home, Dialogues dialogues) {
    this.agent = agent;
    this.name = name;
    this.room = room;
    this.home = home;
    this.stations = new SpeechStations(agent.clock(), name);
    this.voice =
        new RoomVoice(agent, home, sentence -> stations.at(SpeechStations.SPEECH, sentence));
    this.replies =
        new SpokenReplies(
            dialogues,
            new Utterance(name, room, "", Optional.empty()).heardBy(name),
            stations,
            voice);
  }

  /** What one member has heard, in one life of it and its agent. */
  private static final class Ear {
    private final AID of;
    private final String life;
    private final Set<String> told = new HashSet<>();
    private String words = "";
    private double over;

    Ear(AID of, String life) {
      this.of = of;
      this.life = life;
    }

    boolean isOf(AID agent, String itsLife) {
      return of.equals(agent) && life.equals(itsLife);
    }
  }

  /**
   * These are to be members of the room; whoever of them is to hear and does not come is missed.
   */
  public void expect(Set<String> members) {
    for (String member : members) {
      if (!ears.containsKey(member) && feature(member).isPresent()) {
        complainLater(member, "it is not there");
      }
    }
  }

  /**
   * A member of the room is there.
   *
   * @param life by which it is known whether it was started again since
   */
  public void memberPresent(String member, AID of, String life) {
    voice.memberPresent(member, of);
    Ear known = ears.get(member);
    if (known == null || !known.isOf(of, life)) {
      feature(member).ifPresent(feature -> listen(member, new Ear(of, life), feature));
    }
  }

  private Optional<String> feature(String member) {
    return RoomVoice.feature(home.get(), member, LISTEN);
  }

  private void listen(String member, Ear ear, String feature) {
    ears.put(member, ear);
    missed.remove(member);
    voice.forget();
    agent.ask(
        agent.message(
            ACLMessage.REQUEST, ear.of, Orders.watched(member, ear.of.getLocalName(), feature)),
        NO_END,
        reply -> {
          if (ears.get(member) != ear) {
            return;
          }
          if (reply.getPerformative() == ACLMessage.CONFIRM) {
            hear(ear, Words.of(Words.parse(reply.getContent()).get(0)).termsOf("outputs"));
          } else if (reply.getPerformative() != ACLMessage.AGREE) {
            memberLost(member, Replies.reason(reply).orElse("it listens no more"));
          }
        });
  }

  /** The agent that stands for some members is no more; another may take its place. */
  public void agentDied(String other) {
    voice.agentDied(other);
    for (Map.Entry<String, Ear> ear : List.copyOf(ears.entrySet())) {
      if (ear.getValue().of.getLocalName().equals(other)) {
        memberLost(ear.getKey(), "its agent has ended");
      }
    }
  }

  /**
   * A member of the room is gone; it may be back soon.
   *
   * @param reason a clause
   */
  public void memberLost(String member, String reason) {
    voice.memberLost(member);
    if (ears.remove(member) != null) {
      complainLater(member, reason);
    }
  }

  private void complainLater(String member, String reason) {
    Clock.Timer former =
        awaited.put(
            member,
            agent
                .clock()
                .schedule(
                    agent.clock().ofWallAtLeast(COMES_BACK),
                    name,
                    () -> agent.tell(() -> complainOf(member, reason))));
    if (former != null) {
      former.cancel();
    }
  }

  /** The agent ends: nobody is waited for any more. */
  public void end() {
    awaited.values().forEach(Clock.Timer::cancel);
  }

  /**
   * A member of the room has no agent, and gets none for now.
   *
   * @param reason a clause
   */
  public void memberStaysAway(String member, String reason) {
    voice.memberLost(member);
    ears.remove(member);
    if (feature(member).isPresent()) {
      complainOf(member, reason);
    }
  }

  /** Once for each loss, and not while it or another hears what is said in the room. */
  private void complainOf(String member, String reason) {
    if (ears.isEmpty() && missed.add(member)) {
      String sentence = replies.words().phrase("deaf");
      LOG.warn("{} hears nothing in {}, without {}: {}. {}", name, room, member, reason, sentence);
      complaints++;
      agent.send(
          agent.message(
              ACLMessage.INFORM,
              agent.getAID(AgentNames.DESK),
              SpeechWords.content(
                  new Speech(name + "-deaf-" + complaints, room, sentence, Optional.empty()))));
      voice.sayAtLast(sentence);
    }
  }

  /** A whole hypothesis; one that is told again, or too late, is known. */
  private void hear(Ear ear, Map<String, Term> outputs) {
    String speaker = text(outputs, "speaker");
    String words = text(outputs, "words");
    double sentence = outputs.get("sentence") instanceof Term.Number number ? number.value() : 0;
    if (sentence <= ear.over || words.isBlank()) {
      return;
    }
    if (speaker.isEmpty()) {
      LOG.info("{} does not know who speaks in {}, and does nothing.", name, room);
      return;
    }
    Utterance utterance = new Utterance(speaker, room, words, Optional.empty()).heardBy(name);
    if (new Term.Truth(true).equals(outputs.get("over"))) {
      ear.over = sentence;
      ear.words = "";
      ear.told.clear();
      stations.at(SpeechStations.WORD, words + ".");
      askMyself(SayWords.content(utterance), reply -> replies.answered(utterance, reply));
    } else if (!words.equals(ear.words)) {
      ear.words = words;
      stations.at(SpeechStations.WORD, words);
      askMyself(SayWords.unfinished(utterance), reply -> overheard(ear, reply));
    }
  }

  private static String text(Map<String, Term> outputs, String word) {
    return Optional.ofNullable(outputs.get(word)).map(Words::plain).orElse("");
  }

  /** What it hears is said to it as others say it. */
  private void askMyself(Content content, Consumer<ACLMessage> told) {
    agent.ask(agent.message(ACLMessage.REQUEST, agent.getAID(), content), NO_END, told);
  }

  private void overheard(Ear ear, ACLMessage reply) {
    OverheardReply heard = OverheardReply.read(reply.getContent());
    heard.undone().forEach(goal -> once(ear, SpeechStations.BEGUN, goal + " is taken back"));
    heard.begun().forEach(goal -> once(ear, SpeechStations.BEGUN, goal + " is begun"));
    heard.looks().forEach(thing -> once(ear, SpeechStations.LOOK, "looks at " + thing));
    if (heard.nods()) {
      once(ear, SpeechStations.NOD, "nods");
    }
  }

  /** Of what goes on until the end of the sentence. */
  private void once(Ear ear, int number, String what) {
    if (ear.told.add(what)) {
      stations.at(number, what);
    }
  }
}
