package org.maestro.bench;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.assembly.SiteException;
import org.maestro.platform.MaestroPlatform;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** Goals of all kinds, in turn: reached, impossible, cancelled on the way, held for a while. */
public final class SoakGoals {
  private static final long PATIENCE_SECONDS = 120;

  /** The end of a goal. */
  public enum End {
    REACHED("reached"),
    NOT_REACHED("not reached"),
    CANCELLED("cancelled"),
    HELD("held, and then cancelled");

    private final String words;

    End(String words) {
      this.words = words;
    }

    String words() {
      return words;
    }
  }

  private static final String IMPOSSIBLE = "(>= (illuminance zone-b) %d)";
  private static final String TO_CANCEL = "(nextTo Cup Bob)";
  private static final String TO_HOLD = "(keep (>= (illuminance zone-b) 72))";
  private static final List<String> TO_REACH =
      List.of(
          "(>= (illuminance zone-b) 75)",
          "(canSee ?agent Cup)",
          "(nextTo Cup Bob)",
          "(>= (illuminance zone-a) 70)",
          "(canSee ?agent Bob)",
          "(>= (illuminance zone-a) 45)",
          "(in Cup zone-b)");

  private final MaestroPlatform platform;
  private final Consumer<String> progress;

  /**
   * @param progress told of goals that are not reached though they could be
   */
  public SoakGoals(MaestroPlatform platform, Consumer<String> progress) {
    this.platform = platform;
    this.progress = progress;
  }

  /**
   * Returns when the goal is over.
   *
   * @param number of the goal, from 1
   */
  public End pursue(int number) {
    return switch (number % (TO_REACH.size() + 3)) {
      case 7 -> ended(new Conversation(IMPOSSIBLE.formatted(100_000 + number)), false);
      case 8 -> {
        Conversation cancelled = new Conversation(TO_CANCEL);
        cancelled.cancel(await(cancelled.accepted));
        yield ended(cancelled, false);
      }
      case 9 -> {
        Conversation held = new Conversation(TO_HOLD);
        String id = await(held.accepted);
        await(held.held);
        held.cancel(id);
        yield ended(held, true);
      }
      default -> reached(number, TO_REACH.get(number % TO_REACH.size()));
    };
  }

  private End reached(int number, String goal) {
    Conversation conversation = new Conversation(goal);
    End end = ended(conversation, false);
    if (end != End.REACHED) {
      progress.accept("%5d %s: %s".formatted(number, goal, conversation.reasons));
    }
    return end;
  }

  private static End ended(Conversation conversation, boolean held) {
    return switch (await(conversation.ended)) {
      case "achieved" -> End.REACHED;
      case "cancelled" -> held ? End.HELD : End.CANCELLED;
      default -> End.NOT_REACHED;
    };
  }

  private static <T> T await(CompletableFuture<T> what) {
    try {
      return what.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new SiteException("A goal of the soak did not go on in time.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while a goal was awaited.", e);
    }
  }

  /** About one goal. */
  private final class Conversation {
    private final CompletableFuture<String> accepted = new CompletableFuture<>();
    private final CompletableFuture<Boolean> held = new CompletableFuture<>();
    private final CompletableFuture<String> ended = new CompletableFuture<>();
    private volatile List<String> reasons = List.of();

    private Conversation(String goal) {
      Formula formula = SlParser.formula(goal, platform.knowledge().home().vocabulary()::isFluent);
      platform.desk().requestGoal(formula, this::heard);
    }

    private void heard(ACLMessage reply) {
      Words words = Words.of(Words.parse(reply.getContent()).get(0));
      if (reply.getPerformative() == ACLMessage.AGREE) {
        accepted.complete(words.string("goal").orElseThrow());
      } else if (reply.getPerformative() == ACLMessage.CONFIRM) {
        held.complete(true);
      } else if (DeskAgent.isEnd(reply)) {
        reasons =
            words.find("reasons").stream()
                .flatMap(all -> all.terms().stream())
                .map(Words::plain)
                .toList();
        ended.complete(words.string("state").orElse("refused"));
      }
    }

    private void cancel(String id) {
      platform
          .desk()
          .request(
              ACLMessage.REQUEST,
              AgentNames.COORDINATOR,
              Duration.ofSeconds(PATIENCE_SECONDS),
              answer -> {},
              Words.content("cancel", Words.named("goal", Words.name(id))));
    }
  }
}
