import type { ConsoleMessage, Page } from '@playwright/test';
import { toleratedMessages } from './toleratedMessages.js';

/** Collects every problem of the page from now on: warnings and errors on the console, uncaught errors, crashes. */
export function watchProblems(page: Page): string[] {
  const problems: string[] = [];
  page.on('console', (message: ConsoleMessage) => {
    if (message.type() !== 'warning' && message.type() !== 'error') return;
    if (toleratedMessages.some(({ pattern }) => pattern.test(message.text()))) return;
    problems.push(message.text());
  });
  page.on('pageerror', (error) => problems.push(error.stack ?? error.message));
  page.on('crash', () => problems.push('The page crashed.'));
  return problems;
}
