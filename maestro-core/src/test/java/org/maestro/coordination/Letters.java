package org.maestro.coordination;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Messenger;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.Content;
import org.maestro.sl.SlPrinter;

/** Keeps what is said, and what agents are told; some take nothing. */
final class Letters implements Messenger {
  final List<Speech> said = new ArrayList<>();
  final List<Mood> moods = new ArrayList<>();
  final List<String> told = new ArrayList<>();
  final List<GivenAnswer> kept = new ArrayList<>();
  final Set<String> deaf = new TreeSet<>();

  @Override
  public void say(Speech speech, Consumer<Optional<String>> then) {
    said.add(speech);
    then.accept(answer(speech.to()));
  }

  @Override
  public void show(Mood mood, Consumer<Optional<String>> then) {
    moods.add(mood);
    then.accept(answer("everybody"));
  }

  @Override
  public void tell(String part, String agent, Content message, Consumer<Optional<String>> then) {
    told.add("%s %s %s".formatted(part, agent, SlPrinter.print(message)));
    then.accept(answer(agent));
  }

  @Override
  public void keep(GivenAnswer answer, Runnable then) {
    kept.add(answer);
    then.run();
  }

  private Optional<String> answer(String who) {
    return Optional.of(who + " is deaf.").filter(problem -> deaf.contains(who));
  }
}
