package org.maestro.junit;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.maestro.assembly.LocalSite;
import org.slf4j.bridge.SLF4JBridgeHandler;

/** Gives the tests of a {@link MaestroTest} class their stages, and takes these down afterwards. */
public final class MaestroExtension implements ParameterResolver {

  private static final Namespace NAMESPACE = Namespace.create(MaestroExtension.class);

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    return parameter.getParameter().getType() == Stage.class
        && (isShared(context) || context.getTestMethod().isPresent());
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    ExtensionContext owner = isShared(context) ? ofClass(context) : context;
    return owner
        .getStore(NAMESPACE)
        .getOrComputeIfAbsent(Stage.class, key -> set(context), Stage.class);
  }

  private static Stage set(ExtensionContext context) {
    bridgeLogs();
    Class<?> testClass = context.getRequiredTestClass();
    MaestroTest wanted = testClass.getAnnotation(MaestroTest.class);
    SiteWanted site = new SiteWanted(testClass, wanted);
    LocalSite running =
        wanted.clock() == ClockKind.STEPPED
            ? LocalSite.stepped(site.settings(Optional.empty()))
            : LocalSite.paced(site.settings(Optional.of(broker(context).uri())), wanted.speed());
    return new Stage(running, Duration.ofSeconds(wanted.patience()));
  }

  /** JADE logs to java.util.logging, and much; one log decides what is shown. */
  private static void bridgeLogs() {
    if (!SLF4JBridgeHandler.isInstalled()) {
      SLF4JBridgeHandler.removeHandlersForRootLogger();
      SLF4JBridgeHandler.install();
    }
  }

  private static SharedBroker broker(ExtensionContext context) {
    return context
        .getRoot()
        .getStore(NAMESPACE)
        .getOrComputeIfAbsent(SharedBroker.class, key -> new SharedBroker(), SharedBroker.class);
  }

  private static boolean isShared(ExtensionContext context) {
    return context.getRequiredTestClass().isAnnotationPresent(Shared.class);
  }

  private static ExtensionContext ofClass(ExtensionContext context) {
    ExtensionContext owner = context;
    while (owner.getTestMethod().isPresent()) {
      owner = owner.getParent().orElseThrow();
    }
    return owner;
  }
}
