package org.maestro.agents.faces;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.DoubleSupplier;
import org.maestro.agents.content.SaidReply;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Utterance;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.RoomHearing;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.sl.Term;

/**
 * What an agent shows at the faces of the place where it is heard: it looks at what is spoken of,
 * nods when it has understood, moves its mouth for as long as it speaks, smiles when what was
 * wanted is so and frowns when it is not (ADE, 3.3, 4.2 and 5; A41, A60, A63, A90). A room's agent
 * has its own persona at any of them. Agent thread only.
 */
public final class Faces {
  private static final int GOALS_KEPT = 256;

  private final KnowledgeBase knowledge;
  private final String self;
  private final FaceCalls calls;
  private final Map<String, Heard> heardOf = new HashMap<>();
  private final Map<String, String> agentByGoal = BoundedMap.ofNewest(GOALS_KEPT);
  private final Map<String, Feeling> feelingByGoal = BoundedMap.ofNewest(GOALS_KEPT);
  private final Map<String, String> listenerByGoal = BoundedMap.ofNewest(GOALS_KEPT);

  /** What was shown of a sentence that is not over. */
  private record Heard(List<String> looks, boolean nodded) {}

  /**
   * @param self the agent's name, as the home has it where it is a room's
   * @param knowledge of the whole home, whatever the agent itself uses of it
   */
  public Faces(MaestroAgent agent, String self, KnowledgeBase knowledge) {
    this.self = self;
    this.knowledge = knowledge;
    this.calls = new FaceCalls(agent);
  }

  /** Words were heard after which others are to come: it looks and nods once for each cause. */
  public void overheard(Utterance words, List<String> looks, boolean nods) {
    Heard before = heardOf.getOrDefault(words.person(), new Heard(List.of(), false));
    heardOf.put(words.person(), new Heard(looks, before.nodded() || nods));
    List<String> found = new ArrayList<>(looks);
    found.removeAll(before.looks());
    boolean agrees = nods && !before.nodded();
    if (found.isEmpty() && !agrees) {
      return;
    }
    for (FaceMember face : seenBy(place(words))) {
      appear(face, speaker(words));
      found.forEach(
          thing -> calls.order(face, FaceMember.LOOK, Map.of("thing", new Term.Name(thing))));
      if (agrees) {
        calls.order(face, FaceMember.NOD, Map.of());
      }
    }
  }

  /** Whether a device is a face, as its description says. */
  public static boolean isFace(Device device) {
    return new FaceMember(device).feature(FaceMember.SAY).isPresent();
  }

  /**
   * A goal that came of what was said is over.
   *
   * @param sentence that tells so
   */
  public void ended(Utterance words, boolean reached, String sentence) {
    Feeling feeling = reached ? Feeling.GLAD : Feeling.SORRY;
    react(words, feeling, reached ? Optional.empty() : Optional.of(FaceMember.SHAKE));
    say(place(words), speaker(words), sentence, feeling);
  }

  /** What was said is answered, in the name of the room that has understood it. */
  public void answered(Utterance words, SaidReply reply) {
    heardOf.remove(words.person());
    if (reply instanceof SaidReply.TakenOn taken) {
      taken.goals().forEach(goal -> agentByGoal.put(goal, speaker(words)));
      react(words, Feeling.NEUTRAL, Optional.of(FaceMember.NOD));
    } else if (reply instanceof SaidReply.Answered) {
      react(words, Feeling.NEUTRAL, Optional.of(FaceMember.NOD));
    } else if (reply instanceof SaidReply.Over over && over.reached()) {
      react(words, Feeling.GLAD, Optional.empty());
    } else if (reply instanceof SaidReply.Over over) {
      String why =
          over.ends().stream().flatMap(end -> end.reasons().stream()).findFirst().orElse("");
      regret(words, why);
    } else if (reply instanceof SaidReply.Refused refused) {
      regret(words, refused.why());
    } else if (reply instanceof SaidReply.Replied replied) {
      say(place(words), speaker(words), replied.text(), Feeling.NEUTRAL);
    } else if (reply instanceof SaidReply.Asked asked) {
      say(place(words), speaker(words), asked.question(), Feeling.NEUTRAL);
    }
  }

  private void regret(Utterance words, String why) {
    react(words, Feeling.SORRY, Optional.of(FaceMember.SHAKE));
    if (!why.isBlank()) {
      say(place(words), speaker(words), why, Feeling.SORRY);
    }
  }

  private void react(Utterance words, Feeling feeling, Optional<String> gesture) {
    for (FaceMember face : seenBy(place(words))) {
      appear(face, speaker(words));
      express(face, feeling);
      gesture.ifPresent(procedure -> calls.order(face, procedure, Map.of()));
    }
  }

  /**
   * A script says a sentence, or asks a question. Where it has shown no mood, it is under stress as
   * its time runs out.
   *
   * @param timeUsed the share of that which is over; asked where a face is seen
   */
  public void say(Speech speech, DoubleSupplier timeUsed) {
    listenerByGoal.put(speech.goalId(), speech.to());
    if (!seenBy(speech.to()).isEmpty()) {
      say(
          speech.to(),
          agentByGoal.getOrDefault(speech.goalId(), self),
          speech.text(),
          Optional.ofNullable(feelingByGoal.get(speech.goalId()))
              .orElseGet(() -> Feeling.pressed(timeUsed.getAsDouble())));
    }
  }

  /** A script shows a mood, at once where it has spoken, and in all that it says from now on. */
  public void show(Mood mood) {
    Feeling feeling = Feeling.of(mood);
    feelingByGoal.put(mood.goalId(), feeling);
    Optional.ofNullable(listenerByGoal.get(mood.goalId())).stream()
        .flatMap(listener -> seenBy(listener).stream())
        .forEach(face -> express(face, feeling));
  }

  private void say(String listener, String agent, String text, Feeling feeling) {
    Home home = knowledge.home();
    for (FaceMember face : seenBy(listener)) {
      Map<String, Term> parameters = new TreeMap<>();
      parameters.put(FaceMember.TO, new Term.Name(listener));
      parameters.put("text", new Term.Text(text));
      parameters.put("persona", new Term.Text(persona(agent)));
      parameters.put("expression", new Term.Text(feeling.expression()));
      parameters.put("intensity", new Term.Number(feeling.intensity()));
      parameters.put("stress", new Term.Number(feeling.stress()));
      Mentioned.first(text, home).ifPresent(thing -> parameters.put("about", new Term.Name(thing)));
      calls.order(face, FaceMember.SAY, parameters);
    }
  }

  private void appear(FaceMember face, String agent) {
    calls.order(face, FaceMember.SHOW, Map.of("persona", new Term.Text(persona(agent))));
  }

  private void express(FaceMember face, Feeling feeling) {
    calls.order(
        face,
        FaceMember.EXPRESS,
        Map.of(
            "expression", new Term.Text(feeling.expression()),
            "intensity", new Term.Number(feeling.intensity())));
  }

  private List<FaceMember> seenBy(String listener) {
    return FaceMember.seenBy(listener, knowledge.home(), knowledge.snapshot());
  }

  private String speaker(Utterance words) {
    return words.listener().orElse(self);
  }

  private static String place(Utterance words) {
    return words.room().isEmpty() ? words.person() : words.room();
  }

  /** Who is no room's agent, or has none of its own, has that of the home. */
  private String persona(String agent) {
    Home home = knowledge.home();
    return Optional.ofNullable(home.groups().get(agent))
        .flatMap(Group::hearing)
        .flatMap(RoomHearing::persona)
        .orElse(home.label());
  }
}
