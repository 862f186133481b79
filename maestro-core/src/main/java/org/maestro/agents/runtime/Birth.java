package org.maestro.agents.runtime;

import jade.core.Agent;
import jade.core.management.AgentManagementService;
import jade.wrapper.AgentContainer;
import jade.wrapper.ContainerController;
import java.lang.reflect.Field;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;

/**
 * The birth of one agent, as a container of a platform attests it: without one no agent can be
 * made, and no container of another platform takes it in (ADE, 3.1; A21). Only a container of JADE
 * that has joined a platform attests any. Any thread may use it.
 */
public final class Birth {
  /** The class of JADE's containers, which is seen in its own package only. */
  private static final String CONTAINER = "jade.core.AgentContainerImpl";

  private static final StackWalker FRAMES =
      StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE);

  private final String platform;
  private final AtomicBoolean taken = new AtomicBoolean();

  private Birth(String platform) {
    this.platform = platform;
  }

  /**
   * Of one agent, which is to live in a container of the same platform.
   *
   * @throws IllegalStateException when what looks like a container is none, or has ended
   */
  public static Birth of(AgentContainer container) {
    return inside(container)
        .filter(Birth::isOfJade)
        .filter(jade.core.AgentContainer::isJoined)
        .map(real -> new Birth(real.getPlatformID()))
        .orElseThrow(
            () ->
                new IllegalStateException(
                    "Only a container that is part of a platform attests the birth of an agent."));
  }

  /** JADE hands out a wrapper, which anybody can make, of whatever he likes. */
  private static Optional<jade.core.AgentContainer> inside(AgentContainer wrapper) {
    try {
      Field container = ContainerController.class.getDeclaredField("myImpl");
      container.setAccessible(true);
      return Optional.ofNullable((jade.core.AgentContainer) container.get(wrapper));
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("Another JADE than 4.3? It hides its containers.", e);
    }
  }

  private static boolean isOfJade(jade.core.AgentContainer container) {
    Class<?> type = container.getClass();
    return type.getName().equals(CONTAINER)
        && type.getClassLoader() == Agent.class.getClassLoader();
  }

  /**
   * The one agent is made.
   *
   * @throws IllegalStateException when there is no birth, or another agent had it
   */
  static Birth taken(@Nullable Birth birth) {
    if (birth == null) {
      throw new IllegalStateException(
          "An agent is made with its birth, which a container of a platform attests.");
    }
    if (!birth.taken.compareAndSet(false, true)) {
      throw new IllegalStateException("A birth is that of one agent, and this one has been taken.");
    }
    return birth;
  }

  /**
   * An agent without a birth of its own is made: JADE does that in a container, by the name of a
   * class, and nobody else may.
   *
   * @throws IllegalStateException when its maker is another
   */
  static void requireMadeByJade(MaestroAgent made) {
    Optional<Class<?>> maker =
        FRAMES.walk(
            frames ->
                frames
                    .dropWhile(frame -> isAtMaking(frame, made))
                    .<Class<?>>map(StackWalker.StackFrame::getDeclaringClass)
                    .findFirst());
    if (maker
        .map(Class::getEnclosingClass)
        .filter(AgentManagementService.class::equals)
        .isEmpty()) {
      throw new IllegalStateException(
          "Only JADE makes an agent by its class name, in a container of a platform.");
    }
  }

  /** Whether it is this class, a constructor of the agent, or Java on its way to that. */
  private static boolean isAtMaking(StackWalker.StackFrame frame, MaestroAgent made) {
    Class<?> type = frame.getDeclaringClass();
    return type == Birth.class
        || type.getClassLoader() == null
        || (frame.getMethodName().equals("<init>") && type.isInstance(made));
  }

  /**
   * A container takes the agent in.
   *
   * @throws IllegalStateException when it is one of another platform
   */
  void requirePlatform(String its) {
    if (!platform.equals(its)) {
      throw new IllegalStateException(
          "An agent that was born in the platform %s does not come into %s."
              .formatted(platform, its));
    }
  }
}
