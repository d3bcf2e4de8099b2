const proxies = new WeakMap<object, object>();
const originals = new WeakMap<object, object>();

const isWrapped = (value: unknown): value is object =>
  typeof value === 'object' &&
  value !== null &&
  /^\[object (Object|Array)\]$/.test(Object.prototype.toString.call(value));

/** A proxy as `reactive` and `ref` of Vue make them: objects inside come wrapped too, one proxy for each; functions do not. */
export function reactive<T extends object>(target: T): T {
  const original = (originals.get(target) ?? target) as T;
  const known = proxies.get(original);
  if (known) return known as T;
  const proxy = new Proxy(original, {
    get(object, key, receiver) {
      const value: unknown = Reflect.get(object, key, receiver);
      return isWrapped(value) ? reactive(value) : value;
    },
    set: (object, key, value, receiver) => Reflect.set(object, key, originals.get(value) ?? value, receiver),
  });
  proxies.set(original, proxy);
  originals.set(proxy, original);
  return proxy;
}
