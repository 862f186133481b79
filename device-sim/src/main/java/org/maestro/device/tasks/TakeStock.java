package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.hal.ContentsReader;
import org.maestro.rats.member.Execution;

/** Tells whether a thing is in the container that the device is. */
final class TakeStock extends DeviceProcedure {
  private static final double SECONDS = 1;

  private final FeatureContext context;
  private final ContentsReader reader;

  TakeStock(FeatureContext context) {
    this.context = context;
    this.reader = context.driver(ContentsReader.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer object = parameters.pointer("object");
    reader.read(
        contents ->
            report(
                context.feature(),
                execution,
                Map.of("found", contents.contains(object.name())),
                true),
        reason -> execution.fail(FeatureContext.broken(reason)));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
