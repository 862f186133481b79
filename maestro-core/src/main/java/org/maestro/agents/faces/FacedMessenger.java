package org.maestro.agents.faces;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Messenger;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.Content;

/**
 * The way to people of an agent that has faces: what it says and feels is seen there, besides. Whom
 * it tells, and whether that has worked, does not depend on them. Agent thread only.
 */
public final class FacedMessenger implements Messenger {
  private final Messenger way;
  private final Faces faces;
  private final ToDoubleFunction<String> timeUsed;

  /**
   * @param timeUsed the share of the time of a goal that is over, by its id; 0 to 1
   */
  public FacedMessenger(Messenger way, Faces faces, ToDoubleFunction<String> timeUsed) {
    this.way = way;
    this.faces = faces;
    this.timeUsed = timeUsed;
  }

  @Override
  public void say(Speech speech, Consumer<Optional<String>> then) {
    way.say(speech, then);
    faces.say(speech, () -> timeUsed.applyAsDouble(speech.goalId()));
  }

  @Override
  public void show(Mood mood, Consumer<Optional<String>> then) {
    way.show(mood, then);
    faces.show(mood);
  }

  @Override
  public void tell(String part, String agent, Content message, Consumer<Optional<String>> then) {
    way.tell(part, agent, message, then);
  }

  @Override
  public void keep(GivenAnswer answer, Runnable then) {
    way.keep(answer, then);
  }
}
